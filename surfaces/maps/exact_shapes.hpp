#pragma once

// Surface shapes whose contact problem has an exact solution, with their
// position on the grid.

#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// The paraboloid h = -r^2/(2 R) about the centre of the cell, with r measured
/// to the nearest periodic image and the mean removed. Its apex is the node
/// (points_x/2, points_y/2). Hertz's solution is exact for this shape and not
/// for a spherical cap, from which it differs by r^4/(8 R^3).
/// @param radius  R [m] > 0
HeightMap paraboloid(const Grid& grid, double radius);

/// A flat-ended cylinder about the centre of the cell: h = tilt x for r <= R,
/// x from the centre, and -recess outside, with the mean removed. The centre is
/// the node (points_x/2, points_y/2).
/// @param radius  R [m] > 0, less than half of each side
/// @param recess  [m] > 0
/// @param tilt    slope of the end along x [1]
/// @throws std::domain_error  an argument is outside its range
HeightMap flat_punch(const Grid& grid, double radius, double recess,
                     double tilt);

/// The cone h = -slope r about the centre of the cell, with the mean removed.
/// Its tip is the node (points_x/2, points_y/2).
/// @param slope  [1] > 0
HeightMap cone(const Grid& grid, double slope);

/// A flat punch with a rounded edge about the centre of the cell: h = 0 for
/// r <= b and -(r - b)^2/(2 R) outside, with the mean removed.
/// @param radius       b [m] > 0, less than half of each side
/// @param edge_radius  R [m] > 0
/// @throws std::domain_error  an argument is outside its range
HeightMap rounded_punch(const Grid& grid, double radius, double edge_radius);

/// The sinusoidal surface h = D cos(2 pi x/l) of Westergaard's solution. Its
/// crests are at x = 0.
/// @param amplitude   D [m] > 0, half of the height from trough to crest
/// @param wavelength  l [m] > 0, longer than two grid spacings; length_x must
///                    be a whole multiple of it up to a relative difference of
///                    1e-4, for printed numbers, and the wavelength is adjusted
///                    accordingly
/// @throws std::domain_error  an argument is outside its range
HeightMap wave_1d(const Grid& grid, double amplitude, double wavelength);

/// The bisinusoidal surface h = D cos(2 pi x/l) cos(2 pi y/l) of Johnson,
/// Greenwood and Higginson (1985), which is in full contact from
/// p* = sqrt2 pi E* D/l. Its crests are at (0, 0) and (l/2, l/2).
/// @param amplitude   D [m] > 0, half of the height from trough to crest
/// @param wavelength  l [m] > 0; both lengths are whole multiples of it,
///                    as in wave_1d
/// @throws std::domain_error  an argument is outside its range
HeightMap wave_2d(const Grid& grid, double amplitude, double wavelength);

} // namespace asperity::surfaces
