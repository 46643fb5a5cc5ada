#include "surfaces/measured_map.hpp"

#include "cases/text/case_error.hpp"
#include "surfaces/formats/map_file.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/levelling.hpp"
#include "surfaces/maps/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity::surfaces {
namespace {

using cases::SurfaceSpec;

double largest_magnitude(const HeightMap& map) {
  double largest = 0.0;
  for (const double height : map.heights)
    largest = std::max(largest, std::abs(height));
  return largest;
}

/// Uses differences of neighbours inside the map, which need not be periodic.
MapRoughness rms_height_and_slope(const HeightMap& map) {
  const Grid& grid = map.grid;
  const auto mean_square = [&](int step_x, int step_y, double distance) {
    double sum = 0.0;
    for (int iy = 0; iy + step_y < grid.points_y; ++iy)
      for (int ix = 0; ix + step_x < grid.points_x; ++ix)
        sum += std::pow((map.heights[grid.index(ix + step_x, iy + step_y)] -
                         map.heights[grid.index(ix, iy)]) /
                            distance,
                        2);
    return sum / (static_cast<double>(grid.points_x - step_x) *
                  (grid.points_y - step_y));
  };
  return {statistics(map).rms_height,
          std::sqrt(mean_square(1, 0, grid.spacing_x()) +
                    mean_square(0, 1, grid.spacing_y()))};
}

} // namespace

HeightMap levelled_map(const SurfaceSpec& surface) {
  HeightMap map = read_height_map(surface.file, surface.format,
                                  {surface.length, surface.height_unit});
  const double before = largest_magnitude(map);
  remove_trend(map, surface.level);
  const double left = largest_magnitude(map);
  constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
  if (left <= rounding * before)
    throw cases::CaseError(fmt::format(
        "{}: the surface is flat: after levelling, heights of up to {:.3g} m "
        "remain, the roundoff of the original {:.3g} m; there is no roughness",
        surface.file, left, before));
  return map;
}

EdgeEffect edge_effect(const SurfaceSpec& surface) {
  const HeightMap before = levelled_map(surface);
  const HeightMap after = with_edges(before, surface.edges);
  return {rms_height_and_slope(before), rms_height_and_slope(after)};
}

} // namespace asperity::surfaces
