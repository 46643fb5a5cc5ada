#include "surfaces/maps/exact_shapes.hpp"

#include "base/require.hpp"
#include "surfaces/maps/isotropic_spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace asperity::surfaces {
namespace {

/// cos(2 pi x/wavelength) at the nodes of one side. The phase is reduced in
/// integer arithmetic, so that equal heights are bitwise equal.
std::vector<double> cosine_along(const char* length_name, double length,
                                 int points, double wavelength) {
  const double waves = std::round(length / wavelength);
  if (waves < 1.0 ||
      std::abs(length / wavelength - waves) > printed_rounding * waves)
    refuse_argument(length_name, length,
                    fmt::format("an integer multiple of wavelength = {} m",
                                number_text(wavelength)));
  if (2.0 * waves >= points)
    refuse_argument("wavelength", wavelength,
                    fmt::format("longer than two node spacings, {} m",
                                number_text(2.0 * length / points)));
  std::vector<double> cosine(static_cast<std::size_t>(points));
  for (int i = 0; i < points; ++i) {
    const auto step = static_cast<std::int64_t>(waves) * i % points;
    cosine[static_cast<std::size_t>(i)] =
        std::cos(2.0 * std::numbers::pi * static_cast<double>(step) / points);
  }
  return cosine;
}

template <class Height>
HeightMap map_of(const Grid& grid, Height height) {
  HeightMap map{grid, std::vector<double>(grid.size())};
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      map.heights[grid.index(ix, iy)] = height(ix, iy);
  remove_mean(map);
  return map;
}

/// A height that depends on the offset (x, y) from the centre node.
template <class Height>
HeightMap about_centre(const Grid& grid, Height height) {
  const int centre_x = grid.points_x / 2, centre_y = grid.points_y / 2;
  return map_of(grid, [&](int ix, int iy) {
    return height((ix - centre_x) * grid.spacing_x(),
                  (iy - centre_y) * grid.spacing_y());
  });
}

void require_end_inside(double radius, const Grid& grid) {
  require_positive("radius", radius, "m");
  if (2.0 * radius >= std::min(grid.length_x, grid.length_y))
    refuse_argument("radius", radius, "less than half of each side [m]");
}

} // namespace

HeightMap paraboloid(const Grid& grid, double radius) {
  require_positive("radius", radius, "m");
  return about_centre(grid, [&](double x, double y) {
    return -(x * x + y * y) / (2.0 * radius);
  });
}

HeightMap flat_punch(const Grid& grid, double radius, double recess,
                     double tilt) {
  require_end_inside(radius, grid);
  require_positive("recess", recess, "m");
  if (!(std::abs(tilt) * radius < recess))
    refuse_argument("tilt", tilt, "less than recess over radius [1]");
  const double rounding = 1e-12 * radius * radius;
  return about_centre(grid, [&](double x, double y) {
    return x * x + y * y <= radius * radius + rounding ? tilt * x : -recess;
  });
}

HeightMap cone(const Grid& grid, double slope) {
  require_positive("slope", slope, "1");
  return about_centre(
      grid, [&](double x, double y) { return -slope * std::hypot(x, y); });
}

HeightMap rounded_punch(const Grid& grid, double radius, double edge_radius) {
  require_end_inside(radius, grid);
  require_positive("edge_radius", edge_radius, "m");
  return about_centre(grid, [&](double x, double y) {
    const double beyond = std::max(std::hypot(x, y) - radius, 0.0);
    return -beyond * beyond / (2.0 * edge_radius);
  });
}

HeightMap wave_1d(const Grid& grid, double amplitude, double wavelength) {
  require_positive("amplitude", amplitude, "m");
  require_positive("wavelength", wavelength, "m");
  const std::vector<double> along_x =
      cosine_along("length_x", grid.length_x, grid.points_x, wavelength);
  return map_of(grid, [&](int ix, int) {
    return amplitude * along_x[static_cast<std::size_t>(ix)];
  });
}

HeightMap wave_2d(const Grid& grid, double amplitude, double wavelength) {
  require_positive("amplitude", amplitude, "m");
  require_positive("wavelength", wavelength, "m");
  const std::vector<double> along_x =
      cosine_along("length_x", grid.length_x, grid.points_x, wavelength);
  const std::vector<double> along_y =
      cosine_along("length_y", grid.length_y, grid.points_y, wavelength);
  return map_of(grid, [&](int ix, int iy) {
    return amplitude * along_x[static_cast<std::size_t>(ix)] *
           along_y[static_cast<std::size_t>(iy)];
  });
}

} // namespace asperity::surfaces
