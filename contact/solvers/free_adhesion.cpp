#include "contact/solvers/free_adhesion.hpp"

#include "base/ranks/node_sums.hpp"
#include "base/require.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::contact {
namespace {

/// Distance at which a law has at most 1e-16 of its largest tension [m].
double far_distance(const mechanics::ContactInterface& law) {
  double gap = 50.0 * law.adhesion_range;
  while (law.pressure(gap) < 1e-16 * law.pressure_bounds().smallest)
    gap *= 2.0;
  return gap;
}

} // namespace

FreeAdhesion::FreeAdhesion(SurfaceOperator& elasticity,
                           std::span<const double> heights,
                           const mechanics::ContactInterface& law)
    : elasticity_(elasticity),
      extension_(elasticity.periodic_extension()),
      heights_(heights),
      law_(law) {
  if (!extension_)
    refuse_argument("adhesion", law.work_of_adhesion,
                    "left to surfaces that have a periodic extension");
  const auto [lowest, highest] = std::ranges::minmax(heights_);
  lowest_ = lowest;
  highest_ = highest;
  std::vector<double> field(heights_.size(), 1.0);
  elasticity_.displacement(field, field);
  softness_ = std::ranges::max(field);
  std::vector<double> wide(n_nodes(), 0.0);
  each_inside([&](std::size_t i, std::size_t own) {
    wide[i] = heights_[own] - lowest_;
  });
  scale_ = adhesive_scale(*extension_, wide);
  opposed_.assign(n_nodes(), 0);
  each_inside([&](std::size_t i, std::size_t) { opposed_[i] = 1; });
}

template <class Of>
void FreeAdhesion::each_inside(const Of& of) const {
  const Grid& grid = elasticity_.grid();
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      of(extension_->grid().index(ix, iy), grid.index(ix, iy));
}

double FreeAdhesion::level(double nominal_pressure) const {
  return lowest_ - far_distance(law_) - (highest_ - lowest_) -
         4.0 * softness_ * std::abs(nominal_pressure);
}

std::vector<double> FreeAdhesion::state_of(std::span<const double> pressure,
                                           std::span<const double> gap) {
  std::vector<double> state(n_nodes(), 0.0);
  each_inside(
      [&](std::size_t i, std::size_t own) { state[i] = pressure[own]; });
  extension_->displacement(state, state);
  double separation = 0.0;
  each_inside([&](std::size_t i, std::size_t own) {
    separation += gap[own] + heights_[own] - state[i];
  });
  separation /= static_cast<double>(gap.size());
  for (double& height : state)
    height += separation;
  each_inside([&](std::size_t i, std::size_t own) { state[i] = gap[own]; });
  return state;
}

ContactSolution FreeAdhesion::solve(const AdhesiveProblem& problem,
                                    const mechanics::LoadTarget& target,
                                    std::vector<double>& state) {
  if (target.control == mechanics::Control::mean_gap)
    refuse_argument("mean_gap", target.amount,
                    "replaced by a nominal pressure: the surface has free "
                    "boundaries");
  std::vector<double> start = state;
  each_inside(
      [&](std::size_t i, std::size_t own) { start[i] += heights_[own]; });
  // The load of the state may have been larger.
  const double outside = std::min(level(target.amount),
                                  std::ranges::min(start) - far_distance(law_));
  std::vector<double> heights(n_nodes(), outside);
  for (double& height : start)
    height -= outside;
  each_inside([&](std::size_t i, std::size_t own) {
    heights[i] = heights_[own];
    start[i] = state[i];
  });
  const auto share =
      static_cast<double>(heights_.size()) / static_cast<double>(n_nodes());
  ContactSolution answer = solve_adhesive(
      *extension_,
      {heights, law_, problem.gap_tolerance, problem.max_iterations, scale_,
       problem.load_tolerance, opposed_},
      {target.control, share * target.amount}, std::move(start));
  state = answer.gap;
  for (double& height : state)
    height += outside;
  std::vector<double> pressure(heights_.size()), gap(heights_.size());
  each_inside([&](std::size_t i, std::size_t own) {
    state[i] = gap[own] = answer.gap[i];
    pressure[own] = answer.pressure[i];
  });
  answer.load_tolerance /= share;
  if (answer.is_detached)
    answer.note = detached_note(target.amount);
  answer.pressure = std::move(pressure);
  answer.gap = std::move(gap);
  answer.displacement.resize(heights_.size());
  elasticity_.displacement(answer.pressure, answer.displacement);
  ++answer.transforms;
  const Workers workers = elasticity_.workers();
  const auto nodes = static_cast<double>(heights_.size());
  answer.mean_gap = weighted_sum({}, answer.gap, workers) / nodes;
  answer.nominal_pressure = weighted_sum({}, answer.pressure, workers) / nodes;
  return answer;
}

} // namespace asperity::contact
