#include "contact/solvers/projected_state.hpp"

#include "base/maximum.hpp"
#include "contact/solvers/problem_start.hpp"

#include <cmath>
#include <utility>

namespace asperity::contact {
ProjectedState::ProjectedState(SurfaceOperator& elasticity_,
                               const ContactProblem& problem_,
                               const mechanics::LoadTarget& target_,
                               std::span<const double> initial_pressure)
    : elasticity(elasticity_),
      problem(problem_),
      target(target_),
      pressure(
          starting_pressure(elasticity_, problem_, target_, initial_pressure)),
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
  double sum = 0.0;
  if (weights_.empty())
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += a[i] * b[i];
  else
    for (std::size_t i = 0; i < a.size(); ++i)
      sum += weights_[i] * a[i] * b[i];
  return sum;
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
  if (target.control == mechanics::Control::nominal_pressure) {
    rigid_distance = -sum / contact_weight;
  } else {
    double mean_height = 0.0;
    for (std::size_t i = 0; i < nodes; ++i)
      mean_height += weight(i) * heights[i];
    rigid_distance = target.amount + mean_height / static_cast<double>(nodes);
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
  if (target.control == mechanics::Control::nominal_pressure) {
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
  ContactSolution answer;
  if (!is_computed_)
    compute_displacement();
  const std::size_t nodes = pressure.size();
  double pressure_sum = 0.0;
  double gap_sum = 0.0;
  answer.gap.resize(nodes);
  for (std::size_t i = 0; i < nodes; ++i) {
    answer.gap[i] = displacement[i] - problem.heights[i] + rigid_distance;
    pressure_sum += weight(i) * pressure[i];
    gap_sum += weight(i) * answer.gap[i];
  }
  answer.nominal_pressure = pressure_sum / static_cast<double>(nodes);
  answer.mean_gap = gap_sum / static_cast<double>(nodes);
  answer.pressure = std::move(pressure);
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
