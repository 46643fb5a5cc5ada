// Tests of build_surface_on of surfaces/build.hpp: one surface on any grid.
#include "input/input_error.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/resample.hpp"
#include "surfaces/maps/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>

#include "tests/base/fields.hpp"
#include "tests/message_of.hpp"

namespace asperity::surfaces::build_on_test {

using mechanics::SurfaceKind;
using mechanics::SurfaceSpec;

constexpr double length = 1e-5;
constexpr double unit = 2.0 * std::numbers::pi / length;
constexpr double rounding = 1e-14; // of heights, from two transforms

Grid square(int points) {
  return {points, points, length, length};
}

/// 2 nm rms height, waves of 1 to 20 periods.
SurfaceSpec self_affine() {
  SurfaceSpec surface;
  surface.length = length;
  surface.points = 64;
  surface.seed = 7;
  surface.rms_height = 2e-9;
  surface.hurst = 0.8;
  surface.wavevector_low = unit;
  surface.wavevector_roll_off = 4 * unit;
  surface.wavevector_high = 20 * unit;
  surface.rescale = true;
  return surface;
}

/// A map of 16 points per side that has power in every mode.
SurfaceSpec measured() {
  std::string text = "# Width: 10 um\n# Height: 10 um\n# Value units: nm\n";
  for (int iy = 0; iy < 16; ++iy)
    for (int ix = 0; ix < 16; ++ix)
      text += std::to_string((ix * ix * 7 + iy * iy * 5 + ix * iy * 3) % 17) +
              (ix == 15 ? "\n" : "\t");
  SurfaceSpec surface;
  surface.kind = SurfaceKind::measured;
  surface.file = testing::TempDir() + "asperity_build_on_test_map.txt";
  std::ofstream(surface.file) << text;
  return surface;
}

double largest_difference(const HeightMap& a, const HeightMap& b) {
  EXPECT_EQ(a.grid, b.grid);
  return tests::largest_difference(a.heights, b.heights);
}

// Grids of 42, 96 and 162 points sample the surface of the case's 64 with the
// same scale, where they share a node with it.
TEST(BuildSurfaceOn, SamplesOneRandomSurface) {
  for (const auto amplitudes :
       {mechanics::Amplitudes::spectrum, mechanics::Amplitudes::gaussian}) {
    SurfaceSpec surface = self_affine();
    surface.amplitudes = amplitudes;
    const HeightMap own = build_surface(surface, 3);
    for (const int points : {42, 64, 96, 128, 162}) {
      const HeightMap other = build_surface_on(surface, 3, square(points));

      ASSERT_EQ(other.grid, square(points));
      for (int iy = 0; iy < 64; ++iy)
        for (int ix = 0; ix < 64; ++ix)
          if (ix * points % 64 == 0 && iy * points % 64 == 0) {
            EXPECT_NEAR(own.heights[own.grid.index(ix, iy)],
                        other.heights[other.grid.index(ix * points / 64,
                                                       iy * points / 64)],
                        rounding * 2e-9);
          }
    }
  }
}

// At a magnification the surface is the full one without its short waves, not a
// rougher one scaled to the same rms, and it fits a coarser grid.
TEST(BuildSurfaceOn, CutsTheShortWavesOfTheFullSurface) {
  const SurfaceSpec surface = self_affine();
  for (const double highest : {1.0, 5.0, 19.5, 20.0, 70.0}) {
    const HeightMap cut =
        build_surface_on(surface, 0, square(64), highest * unit);

    EXPECT_LT(largest_difference(
                  cut, low_passed(build_surface(surface, 0), highest * unit)),
              rounding * 2e-9);
  }
  const HeightMap coarse = build_surface_on(surface, 0, square(12), 5.0 * unit);
  EXPECT_LT(
      largest_difference(
          coarse, resample(low_passed(build_surface(surface, 0), 5.0 * unit),
                           square(12))
                      .map),
      rounding * 2e-9);
}

TEST(BuildSurfaceOn, RefusesAGridTooCoarse) {
  const SurfaceSpec surface = self_affine();

  EXPECT_EQ(tests::message_of<input::InputError>(
                [&] { build_surface_on(surface, 0, square(40)); }),
            "points of the grid = 40, but must be >= 42 to resolve "
            "surface.wavevector_high = 1.25664e+07 1/m (a wavelength of 5e-07 "
            "m) over surface.length = 1e-05 m");
  EXPECT_EQ(
      tests::message_of<input::InputError>(
          [&] { build_surface_on(surface, 0, square(10), 5.0 * unit); }),
      "points of the grid = 10, but must be >= 12 to resolve "
      "highest_wavevector = 3.14159e+06 1/m (a wavelength of 2e-06 m) over "
      "surface.length = 1e-05 m");
  EXPECT_THROW(build_surface_on(surface, 0, square(64), 0.5 * unit),
               std::domain_error);
  EXPECT_THROW(build_surface_on(surface, 0, square(64), 0.0),
               std::domain_error);
  EXPECT_THROW(build_surface_on(surface, 0, {64, 64, length, 2.0 * length}),
               std::domain_error);
}

// A measured map that is resampled on a finer grid and back is unchanged; a
// grid that would lose waves of it is refused unless they are removed before.
TEST(BuildSurfaceOn, ResamplesAMeasuredMap) {
  const SurfaceSpec surface = measured();
  const HeightMap own = build_surface(surface, 0);
  const double rms_height = statistics(own).rms_height;

  const HeightMap finer = build_surface_on(surface, 0, square(26));

  EXPECT_LT(largest_difference(resample(finer, own.grid).map, own),
            rounding * rms_height);
  EXPECT_EQ(tests::message_of<input::InputError>([&] {
              build_surface_on(surface, 0, square(14));
            }).substr(0, 59),
            "a grid of 14 by 14 points is too coarse for the 16 by 16 of");
  const HeightMap cut = build_surface_on(surface, 0, square(14), 6.5 * unit);
  EXPECT_LT(largest_difference(resample(cut, own.grid).map,
                               low_passed(own, 6.5 * unit)),
            rounding * rms_height);
}

// The exact shapes equal their formula at the nodes; a wave beyond the cut-off
// is absent. Tolerance: eps of the heights, 2 eps of the angle.
TEST(BuildSurfaceOn, EvaluatesTheExactShapes) {
  SurfaceSpec surface = self_affine();
  surface.amplitude = 1e-8;
  surface.wavelength = 5e-6;
  surface.radius = 1e-3;
  const Grid grid = square(26);
  const auto wave = [&](int i) {
    return std::cos(2.0 * unit * i * grid.spacing_x());
  };

  surface.kind = SurfaceKind::wave_1d;
  const HeightMap line = build_surface_on(surface, 0, grid);
  surface.kind = SurfaceKind::wave_2d;
  const HeightMap cross = build_surface_on(surface, 0, grid);
  surface.kind = SurfaceKind::sphere;
  const HeightMap cap = build_surface_on(surface, 0, grid);

  for (int iy = 0; iy < 26; ++iy)
    for (int ix = 0; ix < 26; ++ix) {
      const std::size_t i = grid.index(ix, iy);
      EXPECT_NEAR(line.heights[i], 1e-8 * wave(ix), 1e-22);
      EXPECT_NEAR(cross.heights[i], 1e-8 * wave(ix) * wave(iy), 1e-22);
      const double r2 = std::pow((ix - 13) * grid.spacing_x(), 2) +
                        std::pow((iy - 13) * grid.spacing_y(), 2);
      EXPECT_NEAR(cap.heights[i], cap.heights[grid.index(13, 13)] - r2 / 2e-3,
                  1e-22);
    }
  surface.kind = SurfaceKind::wave_1d;
  EXPECT_LT(
      statistics(build_surface_on(surface, 0, grid, 1.5 * unit)).rms_height,
      1e-23);
}

} // namespace asperity::surfaces::build_on_test
