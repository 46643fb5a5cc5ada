#pragma once

// Computes the autocorrelation of a height map: its average over directions,
// and the lengths Sal and Str of ISO 25178-2.

#include "surfaces/maps/height_map.hpp"

#include <vector>

namespace asperity::surfaces {

/// Mean over all directions at one distance.
struct CorrelationPoint {
  double distance = 0.0;    ///< [m] >= 0
  double correlation = 0.0; ///< <h(x) h(x + r)>/<h^2> [1]
};

struct Autocorrelation {
  std::vector<CorrelationPoint> points; ///< ascending, the first is (0, 1)
  double shortest = 0.0; ///< Sal [m]: smallest distance at which the
                         ///< correlation has fallen to 0.2 in some direction;
                         ///< NaN if it does not fall so far in any
  double longest = 0.0;  ///< largest such distance [m]; NaN if there is a
                         ///< direction in which it does not fall so far
  double aspect_ratio = 0.0; ///< Str = shortest/longest [1] 0..1, NaN with it
};

/// Computes the autocorrelation for lags of up to half of each side, with the
/// mean height subtracted. Without periodicity the sum at each lag runs over
/// the pairs of nodes inside the map and is divided by their number.
/// @throws std::domain_error  the map is flat
Autocorrelation autocorrelation(const HeightMap& map, bool is_periodic);

} // namespace asperity::surfaces
