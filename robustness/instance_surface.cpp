#include "robustness/instance_surface.hpp"

#include "surfaces/maps/exact_shapes.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/realization.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::robustness {
namespace {

using surfaces::HeightMap;

constexpr int terrace_heights = 4;

/// Evaluates the heights as a function of the node, in units of the spacing.
template <class Height>
HeightMap heights_by_node(const Grid& grid, const Height& height) {
  HeightMap map{grid, std::vector<double>(grid.size())};
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      map.heights[grid.index(ix, iy)] = grid.spacing_x() * height(ix, iy);
  return map;
}

/// Rounds every height to one of a few equidistant levels between the lowest
/// and the highest.
HeightMap terraces_of(HeightMap map) {
  const auto [lowest, highest] =
      std::minmax_element(map.heights.begin(), map.heights.end());
  const double low = *lowest;
  const double step = (*highest - low) / (terrace_heights - 1);
  for (double& height : map.heights)
    height = std::round((height - low) / step) * step;
  return map;
}

HeightMap rough_heights(const Instance& instance, const Grid& grid) {
  return surfaces::realize(spectrum_of(instance), grid,
                           {instance.seed, instance.index});
}

HeightMap unscaled(const Instance& instance, const Grid& grid) {
  const int n = grid.points_x;
  switch (instance.shape) {
  case Shape::rough:
    return rough_heights(instance, grid);
  case Shape::terraces:
    return terraces_of(rough_heights(instance, grid));
  case Shape::wave:
    return surfaces::wave_2d(grid, grid.length_x, grid.length_x);
  case Shape::paraboloid:
    return surfaces::paraboloid(grid, grid.length_x);
  case Shape::spike:
    return heights_by_node(
        grid, [](int ix, int iy) { return ix == 0 && iy == 0 ? 1.0 : 0.0; });
  case Shape::step:
    return heights_by_node(
        grid, [n](int ix, int /*iy*/) { return 2 * ix < n ? 1.0 : 0.0; });
  case Shape::sawtooth:
    return heights_by_node(
        grid, [n](int ix, int /*iy*/) { return ix % std::max(2, n / 4); });
  case Shape::checkerboard:
    return heights_by_node(
        grid, [](int ix, int iy) { return (ix + iy) % 2 == 0 ? 1.0 : -1.0; });
  case Shape::flat:
    break;
  }
  return heights_by_node(grid, [](int /*ix*/, int /*iy*/) { return 0.0; });
}

} // namespace

Grid grid_of(const Instance& instance) {
  return {instance.points, instance.points, instance.length, instance.length};
}

surfaces::IsotropicSpectrum spectrum_of(const Instance& instance) {
  const double longest = 2.0 * std::numbers::pi / instance.length;
  const double shortest =
      2.0 * std::numbers::pi / (instance.shortest_wave * instance.spacing());
  // On a small grid, the shortest wave may equal the roll-off wavelength.
  return surfaces::SelfAffineSpectrum::with_rms_slope(
             {instance.hurst, 0.99 * longest,
              std::min(instance.roll_off * longest, shortest),
              std::max(1.01 * longest, shortest)},
             instance.rms_slope)
      .isotropic();
}

InstanceSurface surface_of(const Instance& instance, const Grid& grid) {
  InstanceSurface surface;
  surface.map = unscaled(instance, grid);
  surfaces::remove_mean(surface.map);
  const double slope = surfaces::statistics(surface.map).rms_slope;
  if (slope > 0.0)
    for (double& height : surface.map.heights)
      height *= instance.rms_slope / slope;
  surface.height_scale = surfaces::statistics(surface.map).rms_height;
  if (!(surface.height_scale > 0.0))
    surface.height_scale = instance.rms_slope * grid.spacing_x();
  return surface;
}

} // namespace asperity::robustness
