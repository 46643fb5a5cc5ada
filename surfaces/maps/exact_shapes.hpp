#pragma once

// The shapes whose contact problem has an exact solution. Owns where they lie
// on the grid.

#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// The paraboloid h = -r^2/(2 R) about the centre of the cell, r to the nearest
/// periodic image, mean removed. Its top is the node (points_x/2, points_y/2).
/// This and not the cap of a sphere is what Hertz' solution is exact for; the
/// two differ by r^4/(8 R^3).
/// @param radius  R [m] > 0
HeightMap paraboloid(const Grid& grid, double radius);

/// h = D cos(2 pi x/l): Westergaard's wave. Crests at x = 0.
/// @param amplitude   D [m] > 0, half of crest to trough
/// @param wavelength  l [m] > 0, more than two nodes; length_x is a whole
///                    multiple of it but for the rounding of a printed number,
///                    1e-4 at most, by which the wave is made to fit
/// @throws std::domain_error  an argument is outside its range
HeightMap wave_1d(const Grid& grid, double amplitude, double wavelength);

/// h = D cos(2 pi x/l) cos(2 pi y/l): the wave of Johnson, Greenwood and
/// Higginson (1985), flattened by p* = sqrt2 pi E* D/l. Crests at (0, 0) and
/// (l/2, l/2).
/// @param amplitude   D [m] > 0, half of crest to trough
/// @param wavelength  l [m] > 0; both lengths are whole multiples of it,
///                    as in wave_1d
/// @throws std::domain_error  an argument is outside its range
HeightMap wave_2d(const Grid& grid, double amplitude, double wavelength);

} // namespace asperity::surfaces
