#include "contact/solvers/polonsky_keer.hpp"

#include "base/ranks/node_sums.hpp"
#include "contact/solvers/starting_pressure.hpp"

#include <algorithm>
#include <utility>

namespace asperity::contact {

double ProjectedState::dot(std::span<const double> a,
                           std::span<const double> b) const {
  return weighted_dot(elasticity.nodal_weights(), a, b, workers);
}

void ProjectedState::advance(double step, std::span<const double> direction,
                             std::span<const double> compliance_direction) {
  const std::size_t nodes = pressure.size();
  const std::span<const double> weights = elasticity.nodal_weights();
  const auto [pressure_sum, n_cut] =
      chunked_sum<TwoSums>(
          nodes, workers,
          [&](std::size_t begin, std::size_t end) {
            TwoSums own;
            for (std::size_t i = begin; i < end; ++i) {
              const double wish = pressure[i] - step * direction[i];
              pressure[i] = std::clamp(wish, 0.0, problem.hardness);
              own.values[1] += pressure[i] == wish ? 0.0 : 1.0;
              own.values[0] += weight_of(weights, i) * pressure[i];
            }
            return own;
          })
          .values;
  double scale = 1.0;
  if (problem.has_hardness()) {
    scale_to_target(elasticity, target, problem.hardness, pressure);
    compute_gap();
    return;
  }
  if (by_pressure()) {
    scale = load_scale(target, workers.all_nodes(nodes), pressure_sum);
    for (double& value : pressure)
      value *= scale;
  }
  if (compliance_direction.empty() || n_cut > 0.0) {
    compute_gap();
    return;
  }
  for (std::size_t i = 0; i < nodes; ++i)
    raw_gap[i] = scale * (raw_gap[i] + problem.heights[i] -
                          step * compliance_direction[i]);
  subtract_heights_from_gap();
}

namespace {

/// Adds overlapping nodes to the contact with -step * residual; returns true if
/// there are any on any rank.
bool admit_overlaps(const ProjectedState& state,
                    std::vector<double>& direction) {
  std::size_t entered = 0;
  for (std::size_t i = 0; i < direction.size(); ++i)
    if (state.pressure[i] == 0.0 && state.residual[i] < 0.0) {
      direction[i] = state.residual[i];
      ++entered;
    }
  return total_count(state.elasticity.workers(), entered) > 0;
}

/// Whether the pressure of a node may fall: it is in contact, and does not sink
/// at the hardness.
bool may_fall(const ProjectedState& state, std::size_t i) {
  return (state.freedom[i] & loses) != 0;
}

/// The residual on these nodes only.
void contact_residual(const ProjectedState& state, std::vector<double>& r) {
  for (std::size_t i = 0; i < r.size(); ++i)
    r[i] = may_fall(state, i) ? state.residual[i] : 0.0;
}

} // namespace

ContactSolution polonsky_keer(SurfaceOperator& elasticity,
                              const ContactProblem& problem,
                              const mechanics::LoadTarget& target,
                              std::span<const double> initial_pressure) {
  ProjectedState state(elasticity, problem, target, initial_pressure);
  const std::size_t nodes = state.pressure.size();
  std::vector<double> r(nodes);
  std::vector<double> direction(nodes, 0.0);
  std::vector<double> compliance_direction(nodes);
  double before = 0.0; // <r, r> of the last iteration; 0 means restart
  for (;; ++state.iterations) {
    state.update_residual();
    if (state.is_at_end())
      return std::move(state).solution();

    contact_residual(state, r);
    const double now = state.dot(r, r);
    const double beta = before > 0.0 ? now / before : 0.0;
    for (std::size_t i = 0; i < nodes; ++i)
      direction[i] = may_fall(state, i) ? r[i] + beta * direction[i] : 0.0;
    elasticity.displacement(direction, compliance_direction);
    ++state.transforms;
    const double curvature =
        state.dot(direction, compliance_direction) +
        problem.local_compliance * state.dot(direction, direction);
    const double slope = state.dot(r, direction);
    // A single node in equilibrium has no search direction; overlapping nodes
    // then enter with a step that suits a wavelength on the scale of the grid.
    const double step = curvature > 0.0
                            ? slope / curvature
                            : 1.0 / (elasticity.short_wave_compliance() +
                                     problem.local_compliance);
    const bool has_entered = admit_overlaps(state, direction);
    if (has_entered) // C direction does not include the new nodes
      state.advance(step, direction, {});
    else
      state.advance(step, direction, compliance_direction);
    before = has_entered ? 0.0 : now;
  }
}

} // namespace asperity::contact
