#pragma once

// The heights of the rigid surface on its periodic grid, as a plain pair of
// grid and values.

#include "base/grid.hpp"

#include <functional>
#include <span>
#include <vector>

namespace asperity::surfaces {

/// h(x) [m] at the nodes of the grid, x fastest, positive towards the block.
/// Every builder of this module sets the mean of the heights to 0.
struct HeightMap {
  Grid grid;
  std::vector<double> heights; ///< [m], grid.size() values
};

/// Passes on a map by pieces of whole rows, from the first row to the last; all
/// pieces but the last have an even number of rows.
using HeightRows = std::function<void(
    const std::function<void(std::span<const double> rows)>& take)>;

/// Mean height (1/N) sum_x h(x) [m].
double mean_height(const HeightMap& map);

/// Shifts the map to mean height 0.
/// @par Accuracy  |mean| is at most a few eps of the remaining rms height,
///            whatever the initial mean was.
void remove_mean(HeightMap& map);

} // namespace asperity::surfaces
