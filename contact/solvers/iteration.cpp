#include "contact/solvers/iteration.hpp"

#include "contact/solvers/problem_start.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "ranks/node_sums.hpp"

namespace asperity::contact {
namespace {

std::string not_converged_note(double gap_error, int iterations) {
  return (std::isfinite(gap_error) ? "not converged in "
                                   : "the residual is not finite after ") +
         std::to_string(iterations) + " iterations";
}

} // namespace

Iteration::Iteration(SurfaceOperator& elasticity_,
                     const ContactProblem& problem_,
                     const mechanics::LoadTarget& target_,
                     std::vector<double> initial_pressure)
    : elasticity(elasticity_),
      problem(problem_),
      target(target_),
      pressure(starting_pressure(elasticity_, problem_, target_,
                                 std::move(initial_pressure))) {}

bool Iteration::is_at_end() const {
  return is_converged() || !std::isfinite(gap_error) ||
         iterations >= problem.max_iterations;
}

Iteration::Observed Iteration::observe(std::span<const double> gap,
                                       std::size_t begin,
                                       std::size_t end) const {
  return with_weights(elasticity.nodal_weights(), [&](const auto weight) {
    const auto sum = [=](const double* field) {
      return sum_in_lanes(begin, end,
                          [=](std::size_t i) { return weight[i] * field[i]; });
    };
    return Observed{sum(pressure.data()), sum(gap.data())};
  });
}

ContactSolution Iteration::solution_of(std::vector<double> gap,
                                       std::vector<double> displacement,
                                       const Observed& sums) {
  const auto nodes =
      static_cast<double>(elasticity.workers().all_nodes(pressure.size()));
  ContactSolution answer;
  answer.nominal_pressure = sums.pressure / nodes;
  answer.mean_gap = sums.gap / nodes;
  answer.pressure = std::move(pressure);
  answer.gap = std::move(gap);
  answer.displacement = std::move(displacement);
  answer.gap_error = gap_error;
  answer.iterations = iterations;
  answer.transforms = transforms;
  answer.converged = is_converged();
  if (!answer.converged)
    answer.note = not_converged_note(gap_error, iterations);
  return answer;
}

} // namespace asperity::contact
