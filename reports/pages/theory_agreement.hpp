#pragma once

// The part at the top of a report that describes where the theory does not
// agree with the results of the other methods.

#include "reports/figures/series.hpp"

#include <numbers>
#include <string>
#include <vector>

namespace asperity::reports {

/// Published simulations of Gaussian surfaces have contact areas between that
/// of Persson, sqrt(8/pi), and that of Bush, Gibson and Thomas, sqrt(2 pi), at
/// light load. The ratio of the two is pi/2. Outside this factor in either
/// direction, the theory does not describe the surface.
inline constexpr double largest_area_scale = std::numbers::pi / 2.0;

/// The theory is considered not to describe a surface if its mean gap differs
/// by more than this, in h_rms, where 0.3 < u/h_rms < 1.5. The value is a
/// choice: on Gaussian surfaces the methods of this project differ from the
/// theory by a quarter of it.
inline constexpr double largest_gap_difference = 0.2;

/// Returns one sentence per method and disagreement, with the numbers, based on
/// area_scale_corrected (area_scale if it is absent) and gap_deviation.
std::vector<std::string> theory_disagreements(const ReportEntry& entry);

} // namespace asperity::reports
