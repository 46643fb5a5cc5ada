#include "contact/solvers/projected_state.hpp"

#include "base/maximum.hpp"
#include "contact/operators/node_sums.hpp"
#include "contact/solvers/problem_start.hpp"

#include <cmath>
#include <utility>

namespace asperity::contact {
ProjectedState::ProjectedState(SurfaceOperator& elasticity_,
                               const ContactProblem& problem_,
                               const mechanics::LoadTarget& target_,
                               std::span<const double> initial_pressure)
    : Iteration(elasticity_, problem_, target_, initial_pressure),
      displacement(pressure.size()),
      residual(pressure.size()),
      is_free(pressure.size()),
      weights_(elasticity_.nodal_weights()) {
  compute_displacement();
}

void ProjectedState::compute_displacement() {
  elasticity.displacement(pressure, displacement);
  ++transforms;
  is_computed_ = true;
}

double ProjectedState::dot(std::span<const double> a,
                           std::span<const double> b) const {
  return weighted_dot(weights_, a, b);
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
  double sum = 0.0;
  double contact_weight = 0.0;
  for (std::size_t i = 0; i < nodes; ++i) {
    residual[i] = displacement[i] - heights[i] + compliance * pressure[i];
    if (pressure[i] > 0.0) {
      sum += weight(i) * residual[i];
      contact_weight += weight(i);
    }
  }
  if (by_pressure()) {
    rigid_distance = -sum / contact_weight;
  } else {
    rigid_distance = target.amount + weighted_sum(weights_, heights) /
                                         static_cast<double>(nodes);
  }
  gap_error = 0.0;
  for (std::size_t i = 0; i < nodes; ++i) {
    residual[i] += rigid_distance;
    is_free[i] = pressure[i] > 0.0 || residual[i] < 0.0;
    if (!is_free[i])
      residual[i] *= 0.0; // NaN where it is not finite
    gap_error = maximum(gap_error, std::abs(residual[i]));
  }
}

void ProjectedState::advance(double step, std::span<const double> direction,
                             std::span<const double> compliance_direction) {
  const std::size_t nodes = pressure.size();
  bool is_cut = compliance_direction.empty();
  double sum = 0.0;
  for (std::size_t i = 0; i < nodes; ++i) {
    if (is_free[i]) {
      pressure[i] -= step * direction[i];
      if (pressure[i] < 0.0) {
        pressure[i] = 0.0;
        is_cut = true;
      }
    }
    sum += weight(i) * pressure[i];
  }
  double scale = 1.0;
  if (by_pressure()) {
    scale = load_scale(target, nodes, sum);
    for (double& value : pressure)
      value *= scale;
  }
  if (is_cut) {
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
  return solution_of(std::move(gap), std::move(displacement));
}

} // namespace asperity::contact
