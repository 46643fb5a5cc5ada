#pragma once

// The limits of a sweep over self-affine surfaces: surfaces that are infinitely
// large against the roll-off, on infinitely fine grids.

#include "reports/sweeps/swept_results.hpp"

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace asperity::reports {

/// Quantities that have limits.
inline constexpr std::array<const char*, 5> quantities_with_limits{
    "gamma_matched", "gamma_curve", "gamma_energy", "gamma_slope", "kappa"};

/// The limits of one method for one spectrum.
struct SweepLimit {
  std::string method;
  double hurst = 0.0;
  double ratio = not_a_number; ///< q_1/q_0; NaN: all of them as one
  double nayak = not_a_number; ///< of the largest surface [1]
  std::size_t points = 0;      ///< of the sweep, with this ratio
  std::map<std::string, Estimate> limits = {};
};

/// Fits, for each method and Hurst exponent,
///
///     y = y_inf(q_1/q_0) + a (lambda_0/L)^2 + b (h/lambda_1)^2
///
/// to the means y of the points by least squares, weighted by their scatter:
/// the bias by the finite surface is that of a mean over (L/lambda_0)^2
/// independent parts, and the error of the grid falls at least with this order
/// (docs/numerics/area.md). a and b are common to all q_1/q_0, and 0 if the
/// sweep does not vary L/lambda_0 or h/lambda_1 at a fixed q_1/q_0. A last row
/// has one y_inf for all q_1/q_0. The intervals are those of bootstrap(), with
/// the same realisations at all points, which are the same surfaces.
///
/// @return  nothing if other keys than those of the spectrum and the grid are
///          swept, or if neither a nor b can be determined
std::vector<SweepLimit> sweep_limits(const SweepRecord& record,
                                     const SweptResults& results);

} // namespace asperity::reports
