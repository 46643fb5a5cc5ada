#include "base/maximum.hpp"
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

struct ContactState::ResidualSums {
  double error = 0.0, free_weight = 0.0, freed = 0.0;

  ResidualSums& operator+=(const ResidualSums& other) {
    error = maximum(error, other.error);
    free_weight += other.free_weight;
    freed += other.freed;
    return *this;
  }
};

struct ContactState::BlockSums {
  ResidualSums sums;
  double n_free = 0.0;
};

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
                           ? -contact_sums_.residual / contact_sums_.weight
                           : target.amount + mean_height_;
  rigid_distance_ = rigid;
  // A block without pressure whose lowest gap is not negative stays inactive.
  for (std::size_t block = 0; block < active.size(); ++block)
    if (!(lowest_[block] + rigid >= 0.0))
      active[block] = 1;
  clear_inactive(active, written_, std::span(residual));
  const auto sums =
      with_weights(elasticity.nodal_weights(), [&](const auto weight) {
        return chunked_sum<ResidualSums>(
            pressure.size(), workers, [&](std::size_t begin, std::size_t end) {
              ResidualSums total;
              each_block(
                  begin, end,
                  [&](std::size_t block, std::size_t first, std::size_t last) {
                    if (active[block] == 0)
                      return;
                    const BlockSums own = measure_block(weight, first, last);
                    active[block] = own.n_free > 0.0 ? 1 : 0;
                    total += own.sums;
                  });
              return total;
            });
      });
  gap_error = sums.error;
  free_weight = sums.free_weight;
  freed += sums.freed;
}

template <class Weight>
ContactState::BlockSums ContactState::measure_block(const Weight& weight,
                                                    std::size_t begin,
                                                    std::size_t end) {
  const double compliance = problem.local_compliance;
  const double rigid = rigid_distance_;
  const double* const p = pressure.data();
  const double* const w = raw_gap.data();
  float* const r = residual.data();
  std::uint8_t* const free = freedom.data();
  double error = 0.0, total = 0.0, changed = 0.0, n_free = 0.0;
  double zero = 0.0; // NaN where any value is not finite
#pragma omp simd reduction(+ : total, changed, n_free, zero) reduction(max : error)
  for (std::size_t i = begin; i < end; ++i) {
    const double value = w[i] + compliance * p[i] + rigid;
    const double overlap = value < 0.0 ? 1.0 : 0.0;
    const double code = p[i] > 0.0 ? 2.0 : overlap;
    const double kept = code > 0.0 ? value : 0.0;
    const double size = std::abs(kept);
    const bool was_free = free[i] > fixed;
    changed += was_free != (code > 0.0) ? 1.0 : 0.0;
    free[i] = static_cast<std::uint8_t>(code);
    r[i] = static_cast<float>(kept);
    error = size > error ? size : error;
    zero += 0.0 * value;
    n_free += code > 0.0 ? 1.0 : 0.0;
    total += code > 0.0 ? weight[i] : 0.0;
  }
  return {{error + zero, total, changed}, n_free};
}

} // namespace asperity::contact
