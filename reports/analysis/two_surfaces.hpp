#pragma once

// Describes two surfaces that are analysed but not pressed together: the two
// surfaces of one contact. It owns their sum.

#include "results/types/result.hpp"

#include <optional>

namespace asperity::reports {

/// Returns h_0 + h_1, the equivalent roughness that a flat block sees in place
/// of both surfaces (Sec. 2 of Yang and Persson, 2008). The result must have
/// two surfaces on one grid, both with their heights, and no method other than
/// theory; otherwise nothing is returned.
std::optional<results::SurfaceRecord>
sum_of_two_surfaces(const results::Result& result);

/// Returns the mean over the shells with low <= |q| <= high of
/// C_sum/(C_0 + C_1) [1], which is 1 for uncorrelated surfaces; NaN if there
/// are no such shells.
double sum_spectrum_ratio(const results::Result& result,
                          const results::SurfaceRecord& sum, double low,
                          double high);

} // namespace asperity::reports
