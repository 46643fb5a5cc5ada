#pragma once

// Where the theory does not describe what the other methods found, in words for
// the top of a report.

#include "reports/figures/series.hpp"

#include <numbers>
#include <string>
#include <vector>

namespace asperity::reports {

/// Published simulations of Gaussian surfaces have between the area of Persson,
/// sqrt(8/pi), and that of Bush, Gibson and Thomas, sqrt(2 pi), at light load:
/// a factor of pi/2. Beyond it, either way, the theory is not of this surface.
inline constexpr double largest_area_scale = std::numbers::pi / 2.0;

/// The theory's mean gap, in h_rms where 0.3 < u/h_rms < 1.5, is not that of a
/// surface where it is further off. A choice: the methods here differ from it
/// by a quarter of that on Gaussian surfaces.
inline constexpr double largest_gap_difference = 0.2;

/// A sentence a method and disagreement, with the numbers: of
/// area_scale_corrected (area_scale where there is none) and gap_deviation.
std::vector<std::string> theory_disagreements(const ReportEntry& entry);

} // namespace asperity::reports
