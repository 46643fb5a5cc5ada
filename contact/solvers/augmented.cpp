#include "base/ranks/node_sums.hpp"
#include "base/require.hpp"
#include "contact/solvers/load_sequence.hpp"
#include "contact/solvers/solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::contact {
namespace {

constexpr int max_rounds = 200;

/// Upper limit of 1/k over C at half the Nyquist wavevector: each outer
/// iteration then reduces any penetration to a few hundredths.
constexpr double largest_reduced_compliance = 0.01;

/// Largest gap in contact, or overlap at any node [m].
double wall_error(const ContactSolution& solution, const Workers& workers) {
  return largest_term(solution.gap.size(), workers, [&](std::size_t i) {
    return solution.pressure[i] <= 0.0 && solution.gap[i] >= 0.0
               ? 0.0
               : std::abs(solution.gap[i]);
  });
}

/// Near full contact under gap control the multipliers may converge too slowly.
/// Hard contact has the same answer and starts from their pressure.
ContactSolution finished_by_hard_contact(SurfaceOperator& elasticity,
                                         const ContactProblem& problem,
                                         const mechanics::LoadTarget& target,
                                         const ContactSolution& before,
                                         int n_rounds) {
  ContactProblem hard = problem;
  hard.local_compliance = 0.0;
  ContactSolution answer =
      solve_contact(elasticity, hard, target, before.pressure);
  answer.iterations += before.iterations;
  answer.transforms += before.transforms;
  answer.note = "penetration remained after " + std::to_string(n_rounds) +
                " multiplier updates; finished by the solver of hard contact" +
                (answer.note.empty() ? "" : ": " + answer.note);
  return answer;
}

} // namespace

ContactSolution solve_augmented(SurfaceOperator& elasticity,
                                const ContactProblem& problem,
                                const mechanics::LoadTarget& target,
                                std::span<const double> initial_pressure) {
  require_positive("local_compliance", problem.local_compliance, "m/Pa");
  const Workers workers = elasticity.workers();
  const double compliance =
      std::min(problem.local_compliance,
               largest_reduced_compliance * elasticity.short_wave_compliance());
  std::vector<double> heights(problem.heights.begin(), problem.heights.end());
  ContactProblem round = problem;
  round.heights = heights;
  round.local_compliance = compliance;
  round.gap_tolerance = 0.25 * problem.gap_tolerance;
  mechanics::LoadTarget round_target = target;

  ContactSolution solution =
      solve_contact(elasticity, round, round_target, initial_pressure);
  int iterations = solution.iterations;
  int transforms = solution.transforms;
  int n_rounds = 1;
  while (solution.converged &&
         wall_error(solution, workers) > problem.gap_tolerance &&
         n_rounds < max_rounds) {
    for (std::size_t i = 0; i < heights.size(); ++i)
      heights[i] = problem.heights[i] + compliance * solution.pressure[i];
    const double mean_rise =
        compliance *
        weighted_sum(elasticity.nodal_weights(), solution.pressure, workers) /
        static_cast<double>(workers.all_nodes(heights.size()));
    if (target.control == mechanics::Control::mean_gap)
      round_target.amount = target.amount - mean_rise;

    ContactSolution next =
        solve_contact(elasticity, round, round_target, solution.pressure);
    // Convert to the gap against the original heights.
    for (std::size_t i = 0; i < heights.size(); ++i)
      next.gap[i] += heights[i] - problem.heights[i];
    next.mean_gap += mean_rise;
    iterations += next.iterations;
    transforms += next.transforms;
    ++n_rounds;
    solution = std::move(next);
  }
  solution.iterations = iterations;
  solution.transforms = transforms;
  solution.gap_error = wall_error(solution, workers);
  if (solution.converged && solution.gap_error > problem.gap_tolerance)
    return finished_by_hard_contact(elasticity, problem, target, solution,
                                    n_rounds);
  return solution;
}

} // namespace asperity::contact
