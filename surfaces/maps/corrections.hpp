#pragma once

// Corrects artefacts of instruments in a measured map: it crops the map, aligns
// scan lines, finds spikes and fills missing points.

#include "mechanics/surface_spec.hpp"
#include "surfaces/maps/height_map.hpp"

#include <cstddef>
#include <span>

namespace asperity::surfaces {

/// A rectangle of pixels, and its grid.
struct PixelWindow {
  int first_x = 0;
  int first_y = 0;
  Grid grid;
};

/// The pixels whose centres lie within the window; pixel (i, j) has its centre
/// at ((i + 1/2) spacing_x, (j + 1/2) spacing_y).
/// @throws std::domain_error  the window is not inside the map (within 1e-6 of
///                            its sides), or fewer than two points per side
///                            remain
PixelWindow pixels_of(const Grid& grid, const mechanics::MapWindow& window);

/// Keeps these pixels.
void crop(HeightMap& map, const PixelWindow& pixels);

/// Removes offsets between scan lines, which are rows along x, by the median of
/// differences:
///
///     o_0 = 0,  o_j = o_(j-1) + median over i of (h(i, j) - h(i, j-1))
///     h(i, j) -> h(i, j) - o_j
///
/// over the points that are measured in both rows; without any, o_j = o_(j-1).
/// This also removes the tilt in y, and form that depends on y only.
/// @param map  NaN at missing points
void align_lines(HeightMap& map);

/// Marks spikes as missing by NaN. A spike deviates from the median m of its
/// measured neighbours (up to 8) by more than `threshold` robust standard
/// deviations s,
///
///     |h - m| > threshold s,   s = 1.4826 median |h - m| over all points
///
/// or s = sqrt(pi/2) <|h - m|> if that median is 0.
/// @param map        NaN at missing points
/// @param threshold  [1] >= 3
/// @return  number of spikes
/// @throws std::domain_error  a smaller threshold
std::size_t mark_spikes(HeightMap& map, double threshold);

/// Points that no surface around them explains.
struct FoundSpikes {
  std::size_t count = 0;
  double highest = 0.0; ///< largest |h - m| [m]
};

/// Finds the spikes of mark_spikes() that are single points or pairs: at most
/// one neighbour is nearer to h than to m. Scratches and steps are none.
/// @param threshold  [1] > 0
/// @param least      smallest |h - m| of a spike [m]
FoundSpikes find_spikes(const HeightMap& map, double threshold, double least);

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
