#pragma once

// A periodic map between its nodes and without its short waves. Owns the
// trigonometric interpolation and what a coarser grid cannot carry.

#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// A map on another grid.
struct Resampled {
  HeightMap map;
  double dropped = 0.0; ///< mean square of what the grid does not carry [m^2]
};

/// The trigonometric interpolation of the map at the nodes of `target`:
///
///     h(x) = sum_q a_q exp(i q.x),  a_q = (1/N) sum_x h(x) exp(-i q.x)
///
/// over the modes that the target carries, its Nyquist rows among them. The
/// Nyquist row of an even side is as much +n/2 as -n/2 and so is split between
/// them, half each, in the source, and made of both in the target: a finer grid
/// takes the whole map, and going there and back changes nothing.
///
/// What is dropped is the mean square, over the rectangle, of the interpolation
/// of the map less that of the result: exactly 0 where the target is finer or
/// as fine in both directions.
/// @param target  any grid of the same lengths (is_same_length); the map's own
///                gives the map
/// @throws std::domain_error  lengths that differ, or no points
/// @par Accuracy  common nodes of nested grids to some 1e-15 h_rms
Resampled resample(const HeightMap& map, const Grid& target);

/// The map without its modes of |q| > wavevector (1e-9 of slack, for a wave
/// that is meant to be the last one). Nyquist modes as in mode_power.hpp.
/// @param wavevector  [rad/m] >= 0; 0 leaves the mean
/// @throws std::domain_error  wavevector is outside its range
HeightMap low_passed(const HeightMap& map, double wavevector);

} // namespace asperity::surfaces
