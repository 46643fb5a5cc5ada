#include "surfaces/maps/edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

namespace asperity::surfaces {
namespace {

std::vector<double> hann(int points) {
  std::vector<double> window(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) {
    const double sine = std::sin(std::numbers::pi * (i + 0.5) / points);
    window[static_cast<std::size_t>(i)] = sine * sine;
  }
  return window;
}

double mean_square(const std::vector<double>& window) {
  return std::inner_product(window.begin(), window.end(), window.begin(), 0.0) /
         static_cast<double>(window.size());
}

HeightMap windowed(HeightMap map) {
  const std::vector<double> along_x = hann(map.grid.points_x);
  const std::vector<double> along_y = hann(map.grid.points_y);
  const std::size_t columns = along_x.size();
  const auto weight = [&](std::size_t i) {
    return along_x[i % columns] * along_y[i / columns];
  };

  remove_mean(map); // the roundoff of a large offset would remain in the sum
  double weights = 0.0;
  double weighted_heights = 0.0;
  for (std::size_t i = 0; i < map.heights.size(); ++i) {
    weights += weight(i);
    weighted_heights += weight(i) * map.heights[i];
  }
  const double mean = weighted_heights / weights;
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    map.heights[i] = weight(i) * (map.heights[i] - mean);
  return map;
}

HeightMap mirrored(const HeightMap& map) {
  const Grid& grid = map.grid;
  HeightMap twice{grid_with_edges(grid, mechanics::Edges::mirror),
                  std::vector<double>(4 * grid.size())};
  for (int iy = 0; iy < 2 * grid.points_y; ++iy)
    for (int ix = 0; ix < 2 * grid.points_x; ++ix)
      twice.heights[twice.grid.index(ix, iy)] =
          map.heights[grid.index(std::min(ix, 2 * grid.points_x - 1 - ix),
                                 std::min(iy, 2 * grid.points_y - 1 - iy))];
  return twice;
}

} // namespace

Grid grid_with_edges(const Grid& grid, mechanics::Edges edges) {
  const bool is_mirrored =
      edges == mechanics::Edges::mirror || edges == mechanics::Edges::free;
  return is_mirrored ? Grid{2 * grid.points_x, 2 * grid.points_y,
                            2.0 * grid.length_x, 2.0 * grid.length_y}
                     : grid;
}

HeightMap with_edges(HeightMap map, mechanics::Edges edges) {
  if (edges == mechanics::Edges::window)
    map = windowed(std::move(map));
  else if (edges == mechanics::Edges::mirror || edges == mechanics::Edges::free)
    map = mirrored(map);
  remove_mean(map);
  return map;
}

double hann_power(const Grid& grid) {
  return mean_square(hann(grid.points_x)) * mean_square(hann(grid.points_y));
}

} // namespace asperity::surfaces
