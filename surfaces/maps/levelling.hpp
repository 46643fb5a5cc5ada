#pragma once

// Removes the tilt and the second-order form (bow) that an instrument adds to a
// map.

#include "mechanics/surface_spec.hpp"
#include "surfaces/maps/height_map.hpp"

#include <span>

namespace asperity::surfaces {

/// Subtracts the least-squares polynomial in x and y,
///
///     none   1
///     plane  1, x, y
///     bow    1, x, y, x^2, x y, y^2
///
/// or the sphere or cylinder of round_form.hpp,
///
/// so that at least the mean is removed. On a regular grid these polynomials
/// are spanned by products of the discrete Legendre polynomials of the two
/// sides, which are orthogonal: each coefficient is one projection and no
/// linear system is solved.
/// @par Accuracy  a few eps of the largest height before levelling
/// @throws std::domain_error  as remove_sphere() (round_form.hpp)
void remove_trend(HeightMap& map, mechanics::Levelling levelling);

} // namespace asperity::surfaces
