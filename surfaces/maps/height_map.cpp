#include "surfaces/maps/height_map.hpp"

#include "ranks/in_order.hpp"

namespace asperity::surfaces {

double mean_height(const HeightMap& map) {
  return mean_height(SharedRows(map.grid), map.heights);
}

double mean_height(const SharedRows& rows, std::span<const double> heights) {
  const double total = in_order(&rows, 0.0, [&](double& sum) {
    for (const double height : heights)
      sum += height;
  });
  return total / static_cast<double>(rows.grid().size());
}

void remove_mean(HeightMap& map) {
  remove_mean(SharedRows(map.grid), map.heights);
}

void remove_mean(const SharedRows& rows, std::span<double> heights) {
  // The second pass removes the roundoff of a large first mean.
  for (int pass = 0; pass < 2; ++pass) {
    const double mean = mean_height(rows, heights);
    for (double& height : heights)
      height -= mean;
  }
}

} // namespace asperity::surfaces
