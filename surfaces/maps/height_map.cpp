#include "surfaces/maps/height_map.hpp"

#include <numeric>

namespace asperity::surfaces {

double mean_height(const HeightMap& map) {
  return std::accumulate(map.heights.begin(), map.heights.end(), 0.0) /
         static_cast<double>(map.grid.size());
}

void remove_mean(HeightMap& map) {
  // The second pass removes the roundoff of a large first mean.
  for (int pass = 0; pass < 2; ++pass) {
    const double mean = mean_height(map);
    for (double& height : map.heights)
      height -= mean;
  }
}

} // namespace asperity::surfaces
