#pragma once

// What an instrument adds to a map: tilt and bow. Owns their removal.

#include "cases/types/case.hpp"
#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// Subtracts the least-squares polynomial in x and y,
///
///     none   1
///     plane  1, x, y
///     bow    1, x, y, x^2, x y, y^2
///
/// so that at least the mean is gone. On a regular grid these are spanned by
/// products of the discrete Legendre polynomials of the two sides, which are
/// orthogonal: each coefficient is one projection and nothing is solved.
/// @par Accuracy  some eps of the largest height before
void remove_trend(HeightMap& map, cases::Levelling levelling);

} // namespace asperity::surfaces
