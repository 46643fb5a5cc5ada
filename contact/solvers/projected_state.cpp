#include "contact/solvers/projected_state.hpp"

#include "contact/solvers/starting_pressure.hpp"
#include "ranks/node_sums.hpp"

#include <algorithm>

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

} // namespace asperity::contact
