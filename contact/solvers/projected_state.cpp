#include "contact/solvers/projected_state.hpp"

#include <cmath>
#include <utility>

#include "ranks/node_sums.hpp"

namespace asperity::contact {
ProjectedState::ProjectedState(SurfaceOperator& elasticity_,
                               const ContactProblem& problem_,
                               const mechanics::LoadTarget& target_,
                               std::span<const double> initial_pressure)
    : Iteration(elasticity_, problem_, target_,
                {initial_pressure.begin(), initial_pressure.end()}),
      displacement(pressure.size()),
      residual(pressure.size()),
      is_free(pressure.size()),
      weights_(elasticity_.nodal_weights()),
      workers_(elasticity_.workers()) {
  compute_displacement();
}

void ProjectedState::compute_displacement() {
  elasticity.displacement(pressure, displacement);
  ++transforms;
  is_computed_ = true;
}

double ProjectedState::dot(std::span<const double> a,
                           std::span<const double> b) const {
  return weighted_dot(weights_, a, b, workers_);
}

void ProjectedState::update_residual() {
  measure_residual();
  if (is_computed_ || !is_converged())
    return;
  compute_displacement();
  measure_residual();
}

void ProjectedState::measure_residual() {
  const std::size_t nodes = pressure.size();
  const double compliance = problem.local_compliance;
  const std::span<const double> heights = problem.heights;
  const auto sums = chunked_sum<SeveralSums<2>>(
      nodes, workers_, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0, contact_weight = 0.0;
        for (std::size_t i = begin; i < end; ++i) {
          residual[i] = displacement[i] - heights[i] + compliance * pressure[i];
          if (pressure[i] > 0.0) {
            sum += weight(i) * residual[i];
            contact_weight += weight(i);
          }
        }
        return SeveralSums<2>{{sum, contact_weight}};
      });
  if (by_pressure()) {
    rigid_distance = -sums.values[0] / sums.values[1];
  } else {
    rigid_distance =
        target.amount + weighted_sum(weights_, heights, workers_) /
                            static_cast<double>(workers_.all_nodes(nodes));
  }
  const auto error = chunked_sum<Largest>(
      nodes, workers_, [&](std::size_t begin, std::size_t end) {
        Largest own{0.0};
        for (std::size_t i = begin; i < end; ++i) {
          residual[i] += rigid_distance;
          is_free[i] = pressure[i] > 0.0 || residual[i] < 0.0;
          if (!is_free[i])
            residual[i] *= 0.0; // NaN where it is not finite
          own += {std::abs(residual[i])};
        }
        return own;
      });
  gap_error = error.value;
}

void ProjectedState::advance(double step, std::span<const double> direction,
                             std::span<const double> compliance_direction) {
  const std::size_t nodes = pressure.size();
  const auto sums = chunked_sum<SeveralSums<2>>(
      nodes, workers_, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0, n_cut = 0.0;
        for (std::size_t i = begin; i < end; ++i) {
          if (is_free[i]) {
            const double wish = pressure[i] - step * direction[i];
            n_cut += wish < 0.0 ? 1.0 : 0.0;
            pressure[i] = wish < 0.0 ? 0.0 : wish;
          }
          sum += weight(i) * pressure[i];
        }
        return SeveralSums<2>{{sum, n_cut}};
      });
  double scale = 1.0;
  if (by_pressure()) {
    scale = load_scale(target, workers_.all_nodes(nodes), sums.values[0]);
    for (double& value : pressure)
      value *= scale;
  }
  if (compliance_direction.empty() || sums.values[1] > 0.0) {
    compute_displacement();
  } else {
    is_computed_ = false;
    for (std::size_t i = 0; i < nodes; ++i)
      displacement[i] =
          scale * (displacement[i] - step * compliance_direction[i]);
  }
}

ContactSolution ProjectedState::solution() && {
  if (!is_computed_)
    compute_displacement();
  std::vector<double> gap(pressure.size());
  for (std::size_t i = 0; i < gap.size(); ++i)
    gap[i] = displacement[i] - problem.heights[i] + rigid_distance;
  const auto sums = chunked_sum<Observed>(
      gap.size(), workers_, [&](std::size_t begin, std::size_t end) {
        return observe(gap, begin, end);
      });
  return solution_of(std::move(gap), std::move(displacement), sums);
}

} // namespace asperity::contact
