#pragma once

// The heights of the rigid surface on its periodic grid. Owns nothing but the
// pair: what fills it is a builder, what reads it is anybody.

#include "base/grid.hpp"

#include <vector>

namespace asperity::surfaces {

/// h(x) [m] at the nodes of the grid, x fastest, positive towards the block.
/// Every builder of this room leaves the mean of the heights at 0.
struct HeightMap {
  Grid grid;
  std::vector<double> heights; ///< [m], grid.size() of them
};

/// (1/N) sum_x h(x) [m].
double mean_height(const HeightMap& map);

/// Shifts the map to mean height 0.
/// @par Accuracy  |mean| <= a few eps of the rms height that is left, however
///                far the map was from 0.
void remove_mean(HeightMap& map);

} // namespace asperity::surfaces
