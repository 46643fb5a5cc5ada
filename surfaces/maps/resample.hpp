#pragma once

// Resamples and low-pass filters a periodic map. It contains the trigonometric
// interpolation and the measure of what a coarser grid does not resolve.

#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// A map on another grid.
struct Resampled {
  HeightMap map;
  double dropped = 0.0; ///< mean square of the unresolved part [m^2]
};

/// The trigonometric interpolation of the map at the nodes of `target`:
///
///     h(x) = sum_q a_q exp(i q.x),  a_q = (1/N) sum_x h(x) exp(-i q.x)
///
/// over the modes that the target resolves, including its Nyquist rows. The
/// Nyquist row of an even side represents +n/2 and -n/2 alike. It is therefore
/// split into halves in the source and summed from both in the target: a finer
/// grid represents the whole map, and resampling to it and back changes
/// nothing.
///
/// `dropped` is the mean square, over the rectangle, of the interpolation of
/// the map minus that of the result: exactly 0 if the target is at least as
/// fine in both directions.
/// @param target  any grid of the same lengths (is_same_length); the grid of
///                the map itself returns the map
/// @throws std::domain_error  the lengths differ, or there are no points
/// @par Accuracy  about 1e-15 h_rms at the common nodes of nested grids
/// @par Accuracy  common nodes of nested grids to some 1e-15 h_rms
Resampled resample(const HeightMap& map, const Grid& target);

/// The map without its modes of |q| > wavevector (with a tolerance of 1e-9, for
/// a mode that is meant to be the last one). Nyquist modes are treated as in
/// mode_power.hpp.
/// @param wavevector  [rad/m] >= 0; 0 leaves only the mean
/// @throws std::domain_error  wavevector is outside its range
HeightMap low_passed(const HeightMap& map, double wavevector);

} // namespace asperity::surfaces
