#pragma once

// The figures of a sweep: loading curves of all points, quantities against the
// swept keys, and heat maps.

#include "reports/figures/figures.hpp"
#include "reports/sweeps/sweep_limits.hpp"
#include "reports/sweeps/swept_results.hpp"

#include <memory>
#include <vector>

namespace asperity::reports {

/// Returns u(p) and A(p) of one method at all points: one line per point, with
/// the colour of its value of the first key and the dash type of its value of
/// the second; a band is the 95 % interval of the mean over realisations.
std::vector<Figure> sweep_curve_figures(const SweepRecord& record,
                                        const SweptResults& results);

/// Returns one figure per quantity: its value with its 95 % interval against
/// the first swept key, one line per method and values of the other keys;
/// nothing for a zip that returns to a value of its first key.
std::vector<Figure> sweep_trend_figures(const SweepRecord& record,
                                        const SweptResults& results);

/// Returns one figure per quantity that has limits, against q_1/q_0, and kappa
/// against Nayak's parameter: one line per method and Hurst exponent.
std::vector<Figure> sweep_limit_figures(const std::vector<SweepLimit>& limits);

/// Returns heat maps over the two keys of a product of two keys, one per
/// quantity and method; nothing for other sweeps.
std::vector<Figure> sweep_heat_maps(const SweepRecord& record,
                                    const SweptResults& results);

} // namespace asperity::reports
