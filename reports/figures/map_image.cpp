#include "reports/figures/map_image.hpp"

#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::reports {
namespace {

/// Returns the distance of the tics of an axis whose longer neighbour has some
/// four: at most its length, so that it has two.
double tic_step(double length, double longest) {
  const double step = round_step(longest / 4.0);
  return step <= length ? step : step / 2.0;
}

} // namespace

MapImage map_image(const Grid& grid, const results::MapView& map, double unit) {
  return image_of(grid, reduced(grid, map, most_image_points), unit);
}

MapImage image_of(const Grid& grid, ReducedMap small, double unit) {
  MapImage image{.length_x = 1e6 * grid.length_x,
                 .length_y = 1e6 * grid.length_y,
                 .columns = small.columns,
                 .rows = small.rows,
                 .pitch_x = 1e6 * grid.spacing_x() * small.block_x,
                 .pitch_y = 1e6 * grid.spacing_y() * small.block_y,
                 .values = std::move(small.values)};
  for (double& value : image.values)
    value /= unit;
  const auto [least, largest] = std::ranges::minmax(image.values);
  image.least = least;
  image.largest = largest;
  return image;
}

std::string map_csv(const MapImage& image, double unit) {
  std::string text = fmt::format("{}", image.columns);
  for (int column = 0; column < image.columns; ++column)
    text += fmt::format(",{:.10g}", (column + 0.5) * image.pitch_x);
  std::size_t next = 0;
  for (int row = 0; row < image.rows; ++row) {
    text += fmt::format("\n{:.10g}", (row + 0.5) * image.pitch_y);
    for (int column = 0; column < image.columns; ++column)
      text += fmt::format(",{:.4g}", image.values[next++] / unit);
  }
  return text + "\n";
}

ChartPanel map_panel(const MapImage& image, const std::string& map,
                     const std::string& colors) {
  const double longest = std::max(image.length_x, image.length_y);
  const auto axis = [&](double length) {
    return ChartAxis{.low = 0.0,
                     .high = rounded(length, 6),
                     .tick_step = tic_step(length, longest)};
  };
  return {.x = axis(image.length_x),
          .y = axis(image.length_y),
          .image = ChartImage{.map = map, .colors = colors}};
}

double height_span(const MapImage& image) {
  std::vector<double> sizes;
  sizes.reserve(image.values.size());
  for (const double value : image.values)
    sizes.push_back(std::abs(value));
  const auto rank =
      sizes.begin() + std::lround(0.99 * double(sizes.size() - 1));
  std::ranges::nth_element(sizes, rank);
  return std::min(1.3 * *rank, std::max(-image.least, image.largest));
}

std::string span_note(const MapImage& image) {
  return height_span(image) < std::max(-image.least, image.largest)
             ? " Colours end beyond 99 % of the heights."
             : "";
}

void set_colors(ChartPanel& panel, double low, double high) {
  panel.image->low = rounded(low, 4);
  panel.image->high = rounded(high, 4);
  panel.image->tick_step = round_step((high - low) / 5.0);
}

} // namespace asperity::reports
