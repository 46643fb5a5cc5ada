#include "contact/solvers/contact_state.hpp"

#include "base/ranks/node_sums.hpp"
#include "base/special_numbers.hpp"
#include "contact/solvers/preconditioner.hpp"
#include "contact/solvers/starting_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace asperity::contact {
namespace {

/// The sum of weight times field over the nodes from `begin` to `end`.
template <class Weight>
double sum_of_weighted(const Weight& weight, const double* field,
                       std::size_t begin, std::size_t end) {
  return sum_in_lanes(begin, end,
                      [=](std::size_t i) { return weight[i] * field[i]; });
}

/// The displacement is recomputed when the error has fallen by this factor
/// since the last time: the accumulated single-precision changes have by then
/// left an error of about 1e-7 of the first one.
constexpr double recurrence_range = 1e-4;

std::string not_converged_note(double gap_error, int iterations) {
  return (std::isfinite(gap_error) ? "not converged in "
                                   : "the residual is not finite after ") +
         std::to_string(iterations) + " iterations";
}

} // namespace

ContactState::ContactState(SurfaceOperator& elasticity_,
                           const ContactProblem& problem_,
                           const mechanics::LoadTarget& target_,
                           std::vector<double> initial_pressure)
    : elasticity(elasticity_),
      problem(problem_),
      target(target_),
      workers(elasticity_.workers()),
      pressure(starting_pressure(elasticity_, problem_, target_,
                                 std::move(initial_pressure))),
      raw_gap(pressure.size()),
      freedom(pressure.size()),
      active(blocks_of(pressure.size()), 1),
      work_size_(std::max(2 * pressure.size(),
                          Preconditioner::scratch_size(elasticity_))),
      unset_(std::make_unique_for_overwrite<float[]>(2 * pressure.size() +
                                                     work_size_)),
      written_(active.size(), 1),
      previous_written_(active.size(), 1),
      lowest_(active.size()) {
  residual = unset_part(0, pressure.size());
  previous_residual_ = unset_part(1, pressure.size());
  if (!by_pressure())
    mean_height_ =
        weighted_sum(elasticity.nodal_weights(), problem.heights, workers) /
        static_cast<double>(workers.all_nodes(pressure.size()));
  compute_gap();
}

/// A field of some size from the place of the i-th of the nodes on.
std::span<float> ContactState::unset_part(std::size_t i, std::size_t size) {
  return {unset_.get() + i * pressure.size(), size};
}

bool ContactState::is_at_end() const {
  return is_converged() || !std::isfinite(gap_error) ||
         iterations >= problem.max_iterations;
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
  fields.change = change().data();
  fields.heights = problem.heights.data();
  fields.active = active.data();
  fields.lowest = lowest_.data();
  fields.compliance = problem.local_compliance;
  fields.product_scale = product_scale();
  fields.hardness = problem.hardness;
  return fields;
}

void ContactState::compute_gap() {
  elasticity.displacement(pressure, raw_gap, std::as_writable_bytes(work()));
  ++transforms;
  subtract_heights_from_gap();
  is_computed_ = true;
}

void ContactState::displace(std::span<const float> pressure_change) {
  elasticity.displacement_change(pressure_change, compliance_direction(),
                                 std::as_writable_bytes(change()));
  ++transforms;
}

void ContactState::subtract_heights_from_gap() {
  is_computed_ = false;
  const NodeFields all = fields();
  contact_sums_ = chunked_sum<TwoSums>(
      pressure.size(), workers, [&](std::size_t begin, std::size_t end) {
        return subtract_heights(all, {begin, end});
      });
}

/// raw_gap += factor * field
void ContactState::add_to_gap(double factor, std::span<const float> field) {
  is_computed_ = false;
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
    scale_to_target(elasticity, target, problem.hardness, pressure);
    compute_gap();
    measure_residual();
    computed_error_ = gap_error;
  }
}

void ContactState::measure_residual() {
  if (!by_pressure())
    rigid_distance = target.amount + mean_height_;
  else if (contact_sums_.values[1] > 0.0 || !problem.has_hardness())
    rigid_distance = -contact_sums_.values[0] / contact_sums_.values[1];
  else
    rigid_distance = separation_at_bounds();
  // A block without pressure whose lowest gap is not negative stays inactive.
  for (std::size_t block = 0; block < active.size(); ++block)
    active[block] |=
        static_cast<std::uint8_t>(!(lowest_[block] + rigid_distance >= 0.0));
  clear_inactive(active, written_, residual);
  const NodeFields all = fields();
  const auto sums = chunked_sum<MeasuredNodes>(
      pressure.size(), workers, [&](std::size_t begin, std::size_t end) {
        return measure_nodes(all, {begin, end}, rigid_distance);
      });
  gap_error = sums.error;
  free_weight = sums.weight;
  freed += sums.changed;
}

void ContactState::advance(float step, std::span<float> direction) {
  BlockFlags written(active.size(), 1);
  clear_inactive(active, written, change());
  NodeFields all = fields();
  all.direction = direction.data();
  Advance way{static_cast<double>(step)};
  const bool is_scaled =
      !(problem.has_hardness() && by_pressure()) || stays_below(all, way);
  if (!is_scaled)
    way.factor = load_factor(all, way.step);
  if (!std::isfinite(way.factor)) {
    press_more_nodes();
    return;
  }
  const auto [pressure_sum, cut] = sum<TwoSums>([&](const NodeRange& range) {
                                     return advance_nodes(all, range, way);
                                   }).values;
  if (cut > 0.0) {
    if (is_scaled)
      restore_load(pressure_sum);
    displace(change());
    add_to_gap(1.0, compliance_direction());
  } else {
    add_to_gap(-static_cast<double>(step), compliance_direction());
  }
}

AdvancedLoad ContactState::load_after(const NodeFields& all,
                                      const Advance& way) const {
  return sum<AdvancedLoad>(
      [&](const NodeRange& range) { return sum_advanced(all, range, way); });
}

/// Whether a step reaches the hardness nowhere, also if the load is restored by
/// scaling: it is then a step of hard contact.
bool ContactState::stays_below(const NodeFields& all,
                               const Advance& way) const {
  const AdvancedLoad after = load_after(all, way);
  const double scale =
      load_scale(target, workers.all_nodes(pressure.size()), after.load);
  return after.cut == 0.0 ||
         after.largest * std::max(1.0, scale) < problem.hardness;
}

/// The factor of a step at which the load is the prescribed one, by Newton's
/// method, because the load is a concave function of it. Infinite if all nodes
/// that wish for a pressure have the hardness and carry less than the load.
double ContactState::load_factor(const NodeFields& all, double step) const {
  constexpr int most_rounds = 100;
  constexpr double roundoff = 1e-13;
  const double wanted =
      target.amount * static_cast<double>(workers.all_nodes(pressure.size()));
  double low = 0.0;
  double high = infinity;
  Advance way{step};
  for (int round = 0; round < most_rounds; ++round) {
    const AdvancedLoad now = load_after(all, way);
    const double missing = wanted - now.load;
    if (std::abs(missing) <= roundoff * wanted)
      break;
    (missing > 0.0 ? low : high) = way.factor;
    way.factor += missing / now.slope;
    if (way.factor > low && way.factor < high)
      continue;
    if (!std::isfinite(high))
      return high;
    way.factor = 0.5 * (low + high);
  }
  return way.factor;
}

/// The pressure of springs under all nodes, as stiff as the surface against
/// waves on the scale of the grid: nodes with the smallest gaps get the load
/// that the others cannot carry at the hardness.
void ContactState::press_more_nodes() {
  const double stiffness =
      1.0 / (elasticity.short_wave_compliance() + problem.local_compliance);
  for (std::size_t i = 0; i < pressure.size(); ++i)
    pressure[i] -= stiffness * (raw_gap[i] + rigid_distance +
                                problem.local_compliance * pressure[i]);
  press_to_load(elasticity, target, problem.hardness, pressure);
  set_pressure(std::move(pressure));
}

/// The separation if every node has either no pressure or the hardness: where
/// the former do not overlap and the latter have no gap.
double ContactState::separation_at_bounds() const {
  const auto largest_of = [&](bool is_open) {
    return largest_term(pressure.size(), workers, [&](std::size_t i) {
      return (pressure[i] <= 0.0) != is_open ? -infinity
             : is_open                       ? -raw_gap[i]
                                             : raw_gap[i];
    });
  };
  const double least = largest_of(true);
  const double most = -largest_of(false);
  return std::isfinite(least) ? 0.5 * (least + most) : most;
}

void ContactState::restore_load(double pressure_sum) {
  if (!by_pressure())
    return;
  const double scale =
      load_scale(target, workers.all_nodes(pressure.size()), pressure_sum);
  const NodeFields all = fields();
  sum<Sum>([&](const NodeRange& range) {
    scale_nodes(all, range, scale);
    return Sum{};
  });
}

void ContactState::set_pressure(std::vector<double> other) {
  pressure = std::move(other);
  scale_to_target(elasticity, target, problem.hardness, pressure);
  std::ranges::fill(active, std::uint8_t{1});
  compute_gap();
}

ContactSolution ContactState::solution() && {
  if (!is_computed_) {
    scale_to_target(elasticity, target, problem.hardness, pressure);
    compute_gap();
  }
  residual = previous_residual_ = {};
  unset_.reset();
  freedom = std::vector<std::uint8_t>();
  ContactSolution answer;
  answer.displacement.resize(pressure.size());
  const auto sums = chunked_sum<TwoSums>(
      pressure.size(), workers,
      [&, displacement = answer.displacement.data(), gap = raw_gap.data(),
       p = pressure.data(), h = problem.heights.data(),
       rigid = rigid_distance](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          displacement[i] = gap[i] + h[i];
          gap[i] += rigid;
        }
        return with_weights(elasticity.nodal_weights(), [=](const auto weight) {
          return TwoSums{{sum_of_weighted(weight, p, begin, end),
                          sum_of_weighted(weight, gap, begin, end)}};
        });
      });
  const auto nodes = static_cast<double>(workers.all_nodes(pressure.size()));
  answer.nominal_pressure = sums.values[0] / nodes;
  answer.mean_gap = sums.values[1] / nodes;
  answer.pressure = std::move(pressure);
  answer.gap = std::move(raw_gap);
  answer.gap_error = gap_error;
  answer.iterations = iterations;
  answer.transforms = transforms;
  answer.converged = is_converged();
  if (!answer.converged)
    answer.note = not_converged_note(gap_error, iterations);
  return answer;
}

} // namespace asperity::contact
