#include "surfaces/maps/edges.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
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

void apply_window(HeightMap& map) {
  const std::vector<double> along_x = hann(map.grid.points_x);
  const std::vector<double> along_y = hann(map.grid.points_y);
  const std::size_t columns = along_x.size();
  const auto weight = [&](std::size_t i) {
    return along_x[i % columns] * along_y[i / columns];
  };

  remove_mean(map); // the roundoff of a large offset would remain
  double weights = 0.0, weighted_heights = 0.0;
  for (std::size_t i = 0; i < map.heights.size(); ++i) {
    weights += weight(i);
    weighted_heights += weight(i) * map.heights[i];
  }
  const double mean = weighted_heights / weights;
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    map.heights[i] = weight(i) * (map.heights[i] - mean);
}

HeightMap mirrored(const HeightMap& map, const Grid& twice) {
  const auto width = static_cast<std::size_t>(map.grid.points_x);
  const int n = map.grid.points_y;
  HeightMap image{twice, std::vector<double>(twice.size())};
  auto to = image.heights.begin();
  for (int row = 0; row < 2 * n; ++row) {
    const auto from =
        std::span(map.heights)
            .subspan(map.grid.index(0, std::min(row, 2 * n - 1 - row)), width);
    to = std::ranges::copy(from, to).out;
    to = std::ranges::reverse_copy(from, to).out;
  }
  return image;
}

bool is_mirrored(mechanics::Edges edges) {
  return edges == mechanics::Edges::mirror || edges == mechanics::Edges::free;
}

} // namespace

Grid grid_with_edges(const Grid& grid, mechanics::Edges edges) {
  return is_mirrored(edges) ? Grid{2 * grid.points_x, 2 * grid.points_y,
                                   2.0 * grid.length_x, 2.0 * grid.length_y}
                            : grid;
}

HeightMap with_edges(HeightMap map, mechanics::Edges edges) {
  if (edges == mechanics::Edges::window)
    apply_window(map);
  else if (is_mirrored(edges))
    map = mirrored(map, grid_with_edges(map.grid, edges));
  remove_mean(map);
  return map;
}

double hann_power(const Grid& grid) {
  return mean_square(hann(grid.points_x)) * mean_square(hann(grid.points_y));
}

} // namespace asperity::surfaces
