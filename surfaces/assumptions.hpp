#pragma once

// Whether a map is one that the methods can be asked about. Owns the numbers
// that say so; the limits are the reports' (reports/analysis/warnings.hpp).

#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// Share of <|grad h|^2> that lies above half the Nyquist wavevector,
///
///     |q| > pi/(2 h),  h the larger spacing,
///
/// in waves of fewer than four nodes [1] 0..1; NaN for a flat map. A surface
/// that is resolved has none; of white noise it is 96 %, and of a self-affine
/// surface that goes on to the Nyquist wavevector 1 - 2^(2H - 2).
double unresolved_slope_share(const HeightMap& map);

/// How much more the lines of one direction are shifted against their
/// neighbours than those of the other, by the mean heights m_i of lines along
/// x and along y:
///
///     s^2   = <(m_i - (m_{i-k} + m_{i+k})/2)^2>
///     ratio = (s_along_x/s_along_y) sqrt(L_x/L_y)
///
/// with i inside the map and k lines as near as can be to the larger spacing.
/// The mean of a line averages over its length: of a surface whose statistics
/// are the same in all directions s^2 L is the same for both. A scanned line
/// with an offset of its own raises one of them; so do grooves.
/// @return  [1] > 0, 1 for an isotropic surface; above 1: lines along x are
///          shifted, below 1: those along y. NaN for fewer than three lines, or
///          where the lines of one direction are all alike
double line_offset_ratio(const HeightMap& map);

} // namespace asperity::surfaces
