#pragma once

// Two surfaces that are looked at and not pressed: the faces of one contact.
// Owns what they are together.

#include "results/types/result.hpp"

#include <optional>

namespace asperity::reports {

/// h_0 + h_1: what a flat block meets that stands for both faces, see
/// theory/exact/two_bodies.hpp. Of a result with two surfaces on one grid, both
/// with their heights, and no method but theory; none of any other.
std::optional<results::SurfaceRecord>
sum_of_two_faces(const results::Result& result);

/// Mean over the shells with low <= |q| <= high of C_sum/(C_0 + C_1) [1], which
/// is 1 for faces that know nothing of each other; NaN without shells.
double sum_spectrum_ratio(const results::Result& result,
                          const results::SurfaceRecord& sum, double low,
                          double high);

} // namespace asperity::reports
