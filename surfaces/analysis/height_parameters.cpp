#include "surfaces/analysis/height_parameters.hpp"

#include "surfaces/analysis/local_differences.hpp"
#include "surfaces/maps/statistics.hpp"

#include <array>
#include <cmath>

namespace asperity::surfaces {
namespace {

/// Area of the four triangles of one cell over its projected area.
/// @param corners  heights [m], counter-clockwise from the lower left
double area_ratio_of_cell(const std::array<double, 4>& corners,
                          double spacing_x, double spacing_y) {
  // A triangle between the edge from a to b of length s and the centre has the
  // slope (b - a)/s along the edge and, with d the spacing across, the slope
  // (a + b - 2 centre)/d across it.
  const double centre =
      0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  double ratio = 0.0;
  for (std::size_t edge = 0; edge < 4; ++edge) {
    const double a = corners[edge];
    const double b = corners[(edge + 1) % 4];
    const double along = edge % 2 == 0 ? spacing_x : spacing_y;
    const double across = edge % 2 == 0 ? spacing_y : spacing_x;
    const double slope_along = (b - a) / along;
    const double slope_across = (a + b - 2.0 * centre) / across;
    // sqrt(1 + s^2) - 1 without cancellation for small slopes
    const double square =
        slope_along * slope_along + slope_across * slope_across;
    ratio += 0.25 * square / (1.0 + std::sqrt(1.0 + square));
  }
  return ratio;
}

double developed_area_ratio(const HeightMap& map, bool is_periodic) {
  const Grid& grid = map.grid;
  const int cells_x = grid.points_x - (is_periodic ? 0 : 1);
  const int cells_y = grid.points_y - (is_periodic ? 0 : 1);
  double sum = 0.0;
  for (int iy = 0; iy < cells_y; ++iy) {
    const int above = (iy + 1) % grid.points_y;
    for (int ix = 0; ix < cells_x; ++ix) {
      const int right = (ix + 1) % grid.points_x;
      sum += area_ratio_of_cell({map.heights[grid.index(ix, iy)],
                                 map.heights[grid.index(right, iy)],
                                 map.heights[grid.index(right, above)],
                                 map.heights[grid.index(ix, above)]},
                                grid.spacing_x(), grid.spacing_y());
    }
  }
  return sum / (static_cast<double>(cells_x) * cells_y);
}

} // namespace

HeightParameters height_parameters(const HeightMap& map, bool is_periodic) {
  HeightParameters found;
  found.sdq = local_differences(map, 1, 1, is_periodic).rms_slope();
  found.sdr = developed_area_ratio(map, is_periodic);
  const HeightMoments moments = moments_of(map.heights);
  found.sa = moments.mean_magnitude;
  found.sq = moments.rms;
  found.ssk = moments.skewness;
  found.sku = moments.kurtosis;
  found.sp = moments.highest;
  found.sv = -moments.lowest;
  found.sz = found.sp + found.sv;
  return found;
}

} // namespace asperity::surfaces
