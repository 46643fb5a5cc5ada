#include "contact/solvers/contact_state.hpp"
#include "contact/solvers/problem_start.hpp"

#include <cmath>
#include <utility>

#include "ranks/chunked_sum.hpp"
#include "ranks/node_weights.hpp"

namespace asperity::contact {
namespace {

/// The displacement is recomputed when the error has fallen by this factor
/// since the last time: the accumulated single-precision changes have by then
/// left an error of about 1e-7 of the first one.
constexpr double recurrence_range = 1e-4;

} // namespace

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
                           ? -contact_sums_.first / contact_sums_.second
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
        return measure_nodes(all.at(begin, end), rigid,
                             problem.local_compliance,
                             &active[begin / block_nodes]);
      });
  gap_error = sums.error;
  free_weight = sums.weight;
  freed += sums.changed;
}

} // namespace asperity::contact
