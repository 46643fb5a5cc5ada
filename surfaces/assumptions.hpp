#pragma once

// Measures of whether a height map satisfies the assumptions of the contact
// models. The limits on these measures belong to the reports
// (reports/analysis/warnings.hpp).

#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// Fraction of <|grad h|^2> that lies above half the Nyquist wavevector,
///
///     |q| > pi/(2 h),  h the larger spacing,
///
/// in wavelengths of fewer than four nodes [1] 0..1; NaN for a flat map. It is
/// 0 for a resolved surface, 96 % for white noise, and 1 - 2^(2H - 2) for a
/// surface that is self-affine up to the Nyquist wavevector.
double unresolved_slope_share(const Grid& grid, const HeightRows& heights,
                              int threads = 1);

/// Ratio of the height offsets between neighbouring scan lines of the two
/// directions, from the mean heights m_i of lines along x and along y:
///
///     s^2   = <(m_i - (m_{i-k} + m_{i+k})/2)^2>
///     ratio = (s_along_x/s_along_y) sqrt(L_x/L_y)
///
/// with i inside the map and k the number of lines closest to the larger
/// spacing. The mean of a line averages over its length: for a statistically
/// isotropic surface s^2 L is the same in both directions. A scan line with an
/// offset of its own increases one of the two; so do grooves.
/// @return  [1] > 0, 1 for an isotropic surface; above 1 the lines along x are
///          offset, below 1 those along y. NaN for fewer than three lines, or
///          if all lines of one direction have the same mean
double line_offset_ratio(const Grid& grid, const HeightRows& heights);

/// The step between two heights of a map that a file has in too few digits: the
/// third differences along x, which are 0 for a tilt or a bow, are multiples of
/// it. Only steps above 1e-5 of the rms height are found.
/// @param rms_height  [m] > 0
/// @return  [m]; 0 if the differences are not multiples of one step
double height_step(const Grid& grid, const HeightRows& heights,
                   double rms_height);

/// The rms height of a map about its mean plane [m].
double rms_about_plane(const Grid& grid, const HeightRows& heights);

} // namespace asperity::surfaces
