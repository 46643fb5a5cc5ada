#include "contact/solvers/contact_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ranks/node_sums.hpp"

namespace asperity::contact {
namespace {

/// The displacement is recomputed when the error has fallen by this factor
/// since the last time: the accumulated single-precision changes have by then
/// left an error of about 1e-7 of the first one.
constexpr double recurrence_range = 1e-4;

} // namespace

ContactState::ContactState(SurfaceOperator& elasticity_,
                           const ContactProblem& problem_,
                           const mechanics::LoadTarget& target_,
                           std::vector<double> initial_pressure)
    : Iteration(elasticity_, problem_, target_, std::move(initial_pressure)),
      raw_gap(pressure.size()),
      freedom(pressure.size()),
      workers(elasticity_.workers()),
      active(blocks_of(pressure.size()), 1),
      unset_(std::make_unique_for_overwrite<float[]>(3 * pressure.size())),
      written_(active.size(), 1),
      previous_written_(active.size(), 1),
      lowest_(active.size()),
      change_written_(active.size(), 1) {
  residual = unset_part(0);
  previous_residual_ = unset_part(1);
  change_ = unset_part(2);
  if (!by_pressure())
    mean_height_ =
        weighted_sum(elasticity.nodal_weights(), problem.heights, workers) /
        static_cast<double>(workers.all_nodes(pressure.size()));
  compute_raw_gap();
}

/// One of the three fields.
std::span<float> ContactState::unset_part(std::size_t i) {
  return {unset_.get() + i * pressure.size(), pressure.size()};
}

/// 1 over the largest residual times the pressure that closes it on short
/// waves, to a power of two.
float ContactState::product_scale() const {
  const double product =
      gap_error * gap_error /
      (elasticity.short_wave_compliance() + problem.local_compliance);
  return std::isnormal(product)
             ? std::ldexp(1.0F, std::clamp(-std::ilogb(product), -100, 100))
             : 1.0F;
}

NodeFields ContactState::fields() {
  NodeFields fields;
  const std::span<const double> weights = elasticity.nodal_weights();
  fields.weight = weights.empty() ? nullptr : weights.data();
  fields.pressure = pressure.data();
  fields.raw_gap = raw_gap.data();
  fields.residual = residual.data();
  // Before the first iteration there is no previous one.
  fields.previous_residual =
      iterations > 0 ? previous_residual_.data() : residual.data();
  fields.freedom = freedom.data();
  fields.change = change_.data();
  fields.active = active.data();
  fields.lowest = lowest_.data();
  fields.compliance = problem.local_compliance;
  fields.product_scale = product_scale();
  return fields;
}

void ContactState::compute_raw_gap() {
  elasticity.displacement(pressure, raw_gap);
  ++transforms;
  is_computed_ = true;
  NodeFields all = fields();
  all.heights = problem.heights.data();
  contact_sums_ = chunked_sum<TwoSums>(
      pressure.size(), workers, [&](std::size_t begin, std::size_t end) {
        return subtract_heights(all, {begin, end});
      });
}

void ContactState::add_to_gap(double factor, std::span<const float> field) {
  NodeFields all = fields();
  all.displaced = field.data();
  contact_sums_ = chunked_sum<TwoSums>(
      pressure.size(), workers, [&](std::size_t begin, std::size_t end) {
        return change_gap(all, {begin, end}, factor);
      });
}

void ContactState::update_residual() {
  std::swap(residual, previous_residual_);
  std::swap(written_, previous_written_);
  measure_residual();
  if (is_computed_) {
    computed_error_ = gap_error;
  } else if (is_converged() || gap_error < recurrence_range * computed_error_) {
    scale_to_target(target, elasticity.nodal_weights(), pressure, workers);
    compute_raw_gap();
    measure_residual();
    computed_error_ = gap_error;
  }
}

void ContactState::measure_residual() {
  const double rigid = by_pressure()
                           ? -contact_sums_.values[0] / contact_sums_.values[1]
                           : target.amount + mean_height_;
  rigid_distance_ = rigid;
  // A block without pressure whose lowest gap is not negative stays inactive.
  for (std::size_t block = 0; block < active.size(); ++block)
    active[block] |=
        static_cast<std::uint8_t>(!(lowest_[block] + rigid >= 0.0));
  clear_inactive(active, written_, residual);
  const NodeFields all = fields();
  const auto sums = chunked_sum<MeasuredNodes>(
      pressure.size(), workers, [&](std::size_t begin, std::size_t end) {
        return measure_nodes(all, {begin, end}, rigid);
      });
  gap_error = sums.error;
  free_weight = sums.weight;
  freed += sums.changed;
}

float ContactState::free_mean(std::span<const float> field) {
  if (!by_pressure())
    return 0.0F;
  NodeFields all = fields();
  all.preconditioned = field.data();
  const Sum sum = flagged_sum<Sum>(
      active, field.size(), workers,
      [&](const NodeRange& range) { return sum_free(all, range); });
  return static_cast<float>(sum.value / free_weight);
}

TwoSums ContactState::slopes(std::span<const float> field, float mean) {
  NodeFields all = fields();
  all.preconditioned = field.data();
  return flagged_sum<TwoSums>(
      active, field.size(), workers,
      [&](const NodeRange& range) { return sum_slopes(all, range, mean); });
}

void ContactState::advance(float step, std::span<float> direction,
                           std::span<float> compliance_direction) {
  clear_inactive(active, change_written_, change_);
  is_computed_ = false;
  NodeFields all = fields();
  all.direction = direction.data();
  const TwoSums sums = flagged_sum<TwoSums>(
      active, pressure.size(), workers, [&](const NodeRange& range) {
        return advance_nodes(all, range, static_cast<double>(step));
      });
  if (sums.values[1] > 0.0) {
    restore_load(sums.values[0]);
    elasticity.displacement_change(change_, compliance_direction);
    ++transforms;
    add_to_gap(1.0, compliance_direction);
  } else {
    add_to_gap(-static_cast<double>(step), compliance_direction);
  }
}

void ContactState::restore_load(double pressure_sum) {
  if (!by_pressure())
    return;
  const double scale =
      load_scale(target, workers.all_nodes(pressure.size()), pressure_sum);
  const NodeFields all = fields();
  flagged_sum<Sum>(active, pressure.size(), workers.threads,
                   [&](const NodeRange& range) {
                     scale_nodes(all, range, scale);
                     return Sum{};
                   });
}

ContactSolution ContactState::solution() && {
  if (!is_computed_) {
    scale_to_target(target, elasticity.nodal_weights(), pressure, workers);
    compute_raw_gap();
  }
  residual = change_ = previous_residual_ = {};
  unset_.reset();
  freedom = std::vector<std::uint8_t>();
  std::vector<double> all_displacements(pressure.size());
  double* const displacement = all_displacements.data();
  double* const gap = raw_gap.data();
  const double* const h = problem.heights.data();
  const double rigid = rigid_distance_;
  const auto sums = chunked_sum<Observed>(
      pressure.size(), workers, [&, rigid](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          displacement[i] = gap[i] + h[i];
          gap[i] += rigid;
        }
        return observe(raw_gap, begin, end);
      });
  return solution_of(std::move(raw_gap), std::move(all_displacements), sums);
}

} // namespace asperity::contact
