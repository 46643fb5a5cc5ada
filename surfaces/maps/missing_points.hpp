#pragma once

// Fills missing points of a measured map by harmonic interpolation.

#include "surfaces/maps/height_map.hpp"

#include <cstddef>

namespace asperity::surfaces {

/// Replaces the heights of missing points by the solution of the discrete
/// Laplace equation with the measured heights as boundary values,
///
///     sum over the neighbours n of i inside the map: w_n (h_n - h_i) = 0
///     w_n = 1/spacing_x^2 along x and 1/spacing_y^2 along y
///
/// so that the map is not periodic, no normal derivative at its edges is
/// prescribed but zero, and filled heights lie between the measured ones at the
/// border of their hole. The equations are solved directly, by a sparse
/// Cholesky factorisation.
/// @param map  not finite at missing points
/// @throws std::domain_error  no point is measured
void fill_missing(HeightMap& map);

std::size_t count_missing(const HeightMap& map);

} // namespace asperity::surfaces
