#include "surfaces/maps/edges.hpp"

#include "ranks/in_order.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
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

/// Sums over the points of the window.
struct WindowSums {
  double weights = 0.0, weighted_heights = 0.0;
};

void apply_window(const SharedRows& rows, std::span<double> heights) {
  const std::vector<double> along_x = hann(rows.grid().points_x);
  const std::vector<double> along_y = hann(rows.grid().points_y);
  const std::size_t columns = along_x.size();
  const auto first = static_cast<std::size_t>(rows.first());
  const auto weight = [&](std::size_t i) {
    return along_x[i % columns] * along_y[first + i / columns];
  };

  remove_mean(rows, heights); // the roundoff of a large offset would remain
  const WindowSums sums = in_order(&rows, WindowSums{}, [&](WindowSums& sum) {
    for (std::size_t i = 0; i < heights.size(); ++i) {
      sum.weights += weight(i);
      sum.weighted_heights += weight(i) * heights[i];
    }
  });
  const double mean = sums.weighted_heights / sums.weights;
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] = weight(i) * (heights[i] - mean);
}

std::vector<double> mirrored(const SharedRows& map_rows,
                             std::vector<double> heights,
                             const SharedRows& rows) {
  const int n = map_rows.grid().points_y;
  const int begin = rows.first();
  const int end = begin + rows.count();
  const auto image = [n](int row) { return std::min(row, 2 * n - 1 - row); };
  const int first = std::min(image(begin), image(end - 1));
  const int last =
      begin < n && end > n ? n - 1 : std::max(image(begin), image(end - 1));
  heights = map_rows.rows_at(heights, first, last - first + 1);
  const std::size_t width = map_rows.width();
  std::vector<double> twice(rows.size());
  auto to = twice.begin();
  for (int row = begin; row < end; ++row) {
    const std::span<const double> from = std::span(heights).subspan(
        static_cast<std::size_t>(image(row) - first) * width, width);
    to = std::ranges::copy(from, to).out;
    to = std::ranges::reverse_copy(from, to).out;
  }
  return twice;
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
  const Grid grid = grid_with_edges(map.grid, edges);
  return {grid, with_edges(SharedRows(map.grid), std::move(map.heights), edges,
                           SharedRows(grid))};
}

std::vector<double> with_edges(const SharedRows& map_rows,
                               std::vector<double> heights,
                               mechanics::Edges edges, const SharedRows& rows) {
  if (edges == mechanics::Edges::window)
    apply_window(map_rows, heights);
  else if (is_mirrored(edges))
    heights = mirrored(map_rows, std::move(heights), rows);
  remove_mean(rows, heights);
  return heights;
}

double hann_power(const Grid& grid) {
  return mean_square(hann(grid.points_x)) * mean_square(hann(grid.points_y));
}

} // namespace asperity::surfaces
