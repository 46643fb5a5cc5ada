#include "contact/projected_state.hpp"

#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::contact {
namespace {

void require_size(const char* name, std::size_t size, std::size_t expected) {
  if (size != expected)
    refuse_argument(name, static_cast<double>(size),
                    "the number of grid nodes, " + std::to_string(expected));
}

void require_problem(const ContactProblem& problem, const LoadTarget& target,
                     std::size_t nodes) {
  require_size("heights.size()", problem.heights.size(), nodes);
  require_not_negative("local_compliance", problem.local_compliance, "m/Pa");
  require_positive("gap_tolerance", problem.gap_tolerance, "m");
  for (const double height : problem.heights)
    if (!std::isfinite(height))
      refuse_argument("heights", height, "finite [m]");
  if (target.kind == LoadTarget::Kind::nominal_pressure)
    require_positive("nominal_pressure", target.amount, "Pa");
  else if (problem.local_compliance == 0.0)
    require_positive("mean_gap of a hard wall", target.amount, "m");
  else if (!std::isfinite(target.amount))
    refuse_argument("mean_gap", target.amount, "finite [m]");
}

} // namespace

ProjectedState::ProjectedState(SurfaceOperator& elasticity_,
                               const ContactProblem& problem_,
                               const LoadTarget& target_,
                               std::span<const double> initial_pressure)
    : elasticity(elasticity_),
      problem(problem_),
      target(target_),
      weights_(elasticity_.nodal_weights()) {
  const std::size_t nodes = elasticity.grid().size();
  require_problem(problem, target, nodes);
  displacement.resize(nodes);
  residual.resize(nodes);
  is_free.resize(nodes);
  const bool by_pressure = target.kind == LoadTarget::Kind::nominal_pressure;
  if (initial_pressure.empty()) {
    // Under gap control any positive scale will do: the first step corrects.
    const double start = by_pressure ? target.amount
                                     : problem.gap_tolerance /
                                           (elasticity.short_wave_compliance() +
                                            problem.local_compliance);
    pressure.assign(nodes, start);
  } else {
    require_size("initial_pressure.size()", initial_pressure.size(), nodes);
    for (const double start : initial_pressure)
      require_not_negative("initial_pressure", start, "Pa");
    pressure.assign(initial_pressure.begin(), initial_pressure.end());
  }
  scale_to_target();
  elasticity.displacement(pressure, displacement);
  ++transforms;
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

void ProjectedState::scale_to_target() {
  if (target.kind != LoadTarget::Kind::nominal_pressure)
    return;
  double sum = 0.0;
  for (std::size_t i = 0; i < pressure.size(); ++i)
    sum += weight(i) * pressure[i];
  require_positive("sum of initial_pressure", sum, "Pa");
  const double scale =
      target.amount * static_cast<double>(pressure.size()) / sum;
  for (double& value : pressure)
    value *= scale;
}

void ProjectedState::update_residual() {
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
  if (target.kind == LoadTarget::Kind::nominal_pressure) {
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
      residual[i] = 0.0;
    gap_error = std::max(gap_error, std::abs(residual[i]));
  }
}

void ProjectedState::mask(std::span<double> field) const {
  const std::size_t nodes = field.size();
  double mean = 0.0;
  if (target.kind == LoadTarget::Kind::nominal_pressure) {
    double free_weight = 0.0;
    for (std::size_t i = 0; i < nodes; ++i)
      if (is_free[i]) {
        mean += weight(i) * field[i];
        free_weight += weight(i);
      }
    mean /= free_weight;
  }
  for (std::size_t i = 0; i < nodes; ++i) {
    field[i] = is_free[i] ? field[i] - mean : 0.0;
    // A node without pressure can only gain it: p - step * field >= 0.
    if (pressure[i] == 0.0 && field[i] > 0.0)
      field[i] = 0.0;
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
  if (target.kind == LoadTarget::Kind::nominal_pressure) {
    scale = target.amount * static_cast<double>(nodes) / sum;
    for (double& value : pressure)
      value *= scale;
  }
  if (is_cut) {
    elasticity.displacement(pressure, displacement);
    ++transforms;
  } else {
    for (std::size_t i = 0; i < nodes; ++i)
      displacement[i] =
          scale * (displacement[i] - step * compliance_direction[i]);
  }
}

ContactSolution ProjectedState::solution() && {
  ContactSolution answer;
  // The recurrence has gathered rounding: the fields shown are exact.
  elasticity.displacement(pressure, displacement);
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
  answer.transforms = transforms + 1;
  answer.converged = is_converged();
  if (!answer.converged)
    answer.note =
        "not converged in " + std::to_string(iterations) + " iterations";
  return answer;
}

} // namespace asperity::contact
