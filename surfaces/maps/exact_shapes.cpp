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
std::vector<double> rows_of(const SharedRows& rows, Height height) {
  const Grid& grid = rows.grid();
  std::vector<double> heights(rows.size());
  for (int iy = 0; iy < rows.count(); ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      heights[grid.index(ix, iy)] = height(ix, rows.first() + iy);
  remove_mean(rows, heights);
  return heights;
}

} // namespace

HeightMap paraboloid(const Grid& grid, double radius) {
  return {grid, paraboloid_rows(SharedRows(grid), radius)};
}

std::vector<double> paraboloid_rows(const SharedRows& rows, double radius) {
  require_positive("radius", radius, "m");
  const Grid& grid = rows.grid();
  const int centre_x = grid.points_x / 2;
  const int centre_y = grid.points_y / 2;
  return rows_of(rows, [&](int ix, int iy) {
    const double x = (ix - centre_x) * grid.spacing_x();
    const double y = (iy - centre_y) * grid.spacing_y();
    return -(x * x + y * y) / (2.0 * radius);
  });
}

HeightMap flat_punch(const Grid& grid, double radius, double recess,
                     double tilt) {
  return {grid, flat_punch_rows(SharedRows(grid), radius, recess, tilt)};
}

std::vector<double> flat_punch_rows(const SharedRows& rows, double radius,
                                    double recess, double tilt) {
  const Grid& grid = rows.grid();
  require_positive("radius", radius, "m");
  require_positive("recess", recess, "m");
  if (2.0 * radius >= std::min(grid.length_x, grid.length_y))
    refuse_argument("radius", radius, "less than half of each side [m]");
  if (!(std::abs(tilt) * radius < recess))
    refuse_argument("tilt", tilt, "less than recess over radius [1]");
  const double rounding = 1e-12 * radius * radius;
  const int centre_x = grid.points_x / 2;
  const int centre_y = grid.points_y / 2;
  return rows_of(rows, [&](int ix, int iy) {
    const double x = (ix - centre_x) * grid.spacing_x();
    const double y = (iy - centre_y) * grid.spacing_y();
    return x * x + y * y <= radius * radius + rounding ? tilt * x : -recess;
  });
}

HeightMap wave_1d(const Grid& grid, double amplitude, double wavelength) {
  return {grid, wave_1d_rows(SharedRows(grid), amplitude, wavelength)};
}

std::vector<double> wave_1d_rows(const SharedRows& rows, double amplitude,
                                 double wavelength) {
  const Grid& grid = rows.grid();
  require_positive("amplitude", amplitude, "m");
  require_positive("wavelength", wavelength, "m");
  const std::vector<double> along_x =
      cosine_along("length_x", grid.length_x, grid.points_x, wavelength);
  return rows_of(rows, [&](int ix, int) {
    return amplitude * along_x[static_cast<std::size_t>(ix)];
  });
}

HeightMap wave_2d(const Grid& grid, double amplitude, double wavelength) {
  return {grid, wave_2d_rows(SharedRows(grid), amplitude, wavelength)};
}

std::vector<double> wave_2d_rows(const SharedRows& rows, double amplitude,
                                 double wavelength) {
  const Grid& grid = rows.grid();
  require_positive("amplitude", amplitude, "m");
  require_positive("wavelength", wavelength, "m");
  const std::vector<double> along_x =
      cosine_along("length_x", grid.length_x, grid.points_x, wavelength);
  const std::vector<double> along_y =
      cosine_along("length_y", grid.length_y, grid.points_y, wavelength);
  return rows_of(rows, [&](int ix, int iy) {
    return amplitude * along_x[static_cast<std::size_t>(ix)] *
           along_y[static_cast<std::size_t>(iy)];
  });
}

} // namespace asperity::surfaces
