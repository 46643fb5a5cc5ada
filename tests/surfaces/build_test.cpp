// Tests of surfaces/build.hpp: each kind of surface of a case is built, and
// one surface on any grid.
#include "input/input_error.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/resample.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/measured_map.hpp"
#include "tests/base/fields.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace asperity::surfaces::build_test {

using mechanics::SurfaceKind;
using mechanics::SurfaceSpec;

constexpr double unit = 2.0 * std::numbers::pi / 1e-5;

SurfaceSpec self_affine() {
  SurfaceSpec surface;
  surface.length = 1e-5;
  surface.points = 64;
  surface.seed = 7;
  surface.rms_height = 2e-9;
  surface.hurst = 0.8;
  surface.wavevector_low = unit;
  surface.wavevector_roll_off = 4 * unit;
  surface.wavevector_high = 20 * unit;
  return surface;
}

SurfaceSpec with_file(SurfaceKind kind, const std::string& name,
                      const std::string& text) {
  SurfaceSpec surface = self_affine();
  surface.kind = kind;
  surface.file = testing::TempDir() + "asperity_build_test_" + name;
  surface.rms_height.reset();
  std::ofstream(surface.file) << text;
  return surface;
}

// Without `rescale` the realisation has the sum over its modes, near the
// requested rms; with it, it has exactly the requested height or slope.
TEST(BuildSurface, RescalesToTheRequestedRms) {
  SurfaceSpec surface = self_affine();
  const double as_drawn = statistics(build_surface(surface, 0)).rms_height;
  surface.rescale = true;
  const double height = statistics(build_surface(surface, 0)).rms_height;
  surface.rms_height.reset();
  surface.rms_slope = 0.1;
  const double slope = statistics(build_surface(surface, 0)).rms_slope;

  EXPECT_NEAR(as_drawn / 2e-9, 1.0, 0.1);
  EXPECT_GT(std::abs(as_drawn / 2e-9 - 1.0), 1e-6);
  EXPECT_NEAR(height / 2e-9, 1.0, 1e-14);
  EXPECT_NEAR(slope / 0.1, 1.0, 1e-13);
}

// Wavevectors that are printed with five digits mean the waves of the cell: 2
// pi/ (10 um) = 6.28319e5 is in a band that begins at "6.2832e5", and a
// roll-off printed as 6.2831e5 is that beginning. The wave (1, 0) carries the
// largest part of the height; tolerance: h_rms changes with C_0 by the same
// 1e-4.
TEST(BuildSurface, TakesWavevectorsAsTheyArePrinted) {
  SurfaceSpec surface = self_affine();
  surface.wavevector_roll_off = unit;
  const double exact = statistics(build_surface(surface, 0)).rms_height;
  surface.wavevector_low = 6.2832e5;
  surface.wavevector_roll_off = 6.2831e5;

  const double printed = statistics(build_surface(surface, 0)).rms_height;

  EXPECT_NEAR(printed / exact, 1.0, 1e-4);
}

TEST(BuildSurface, DrawsRealizationsOnlyOfRandomKinds) {
  SurfaceSpec surface = self_affine();
  EXPECT_TRUE(is_random(surface.kind));
  EXPECT_NE(build_surface(surface, 0).heights,
            build_surface(surface, 1).heights);

  surface.kind = SurfaceKind::sphere;
  surface.radius = 1e-3;
  EXPECT_FALSE(is_random(surface.kind));
  EXPECT_EQ(build_surface(surface, 0).heights,
            build_surface(surface, 1).heights);
}

// A rough ball is the sum of the roughness and of a paraboloid, -r^2/(2 R) from
// the highest point of the form, on every grid.
TEST(BuildSurface, LaysRoughnessOnItsForm) {
  SurfaceSpec surface = self_affine();
  const HeightMap rough = build_surface(surface, 0);
  surface.form_radius = 2e-4;
  const HeightMap ball = build_surface(surface, 0);
  const HeightMap again = build_surface_on(surface, 0, ball.grid);

  const std::size_t apex = ball.grid.index(32, 32);
  const auto form = [&](std::size_t node) {
    return ball.heights[node] - rough.heights[node];
  };
  const double spacing = ball.grid.spacing_x();
  for (const auto& [ix, iy] : {std::pair{40, 32}, {32, 2}, {10, 50}}) {
    const double r2 =
        ((ix - 32) * (ix - 32) + (iy - 32) * (iy - 32)) * spacing * spacing;
    EXPECT_NEAR(form(ball.grid.index(ix, iy)) - form(apex), -r2 / (2.0 * 2e-4),
                1e-20);
  }
  EXPECT_EQ(again.heights, ball.heights);
}

// A table of two rows is one power law, C = C_0 (q/q_0)^-2, of <h^2> = 2 pi C_0
// q_0^2 ln(q_1/q_0); a requested rms rescales the table.
TEST(BuildSurface, TakesATableWithItsOwnOrARequestedAmplitude) {
  SurfaceSpec surface =
      with_file(SurfaceKind::spectrum, "table.csv", "2e6, 4e-30\n1e7, 16e-32");

  const IsotropicSpectrum own = formula_spectrum(surface);
  surface.rms_slope = 0.25;
  const IsotropicSpectrum requested = formula_spectrum(surface);

  const double mean_square =
      2.0 * std::numbers::pi * 4e-30 * 4e12 * std::log(5.0);
  EXPECT_NEAR(own.mean_square_height / mean_square, 1.0, 1e-13);
  EXPECT_NEAR(requested.mean_square_slope, 0.0625, 1e-15);
  const double factor = requested.mean_square_slope / own.mean_square_slope;
  EXPECT_NEAR(requested.density(3e6) / own.density(3e6) / factor, 1.0, 1e-14);

  surface.rescale = true;
  EXPECT_NEAR(statistics(build_surface(surface, 0)).rms_slope, 0.25, 1e-13);
}

// A file is read, levelled and made periodic in this order. The map is a plane
// plus a checkerboard of +-0.5 nm, which is orthogonal to any plane on even
// sides and whose rms remains. Tolerance: 100 nm of trend, 20 eps of it.
TEST(BuildSurface, ReadsLevelsAndMirrorsAMeasuredMap) {
  std::string text = "# Width: 8 um\n# Height: 4 um\n# Value units: nm\n";
  for (int iy = 0; iy < 4; ++iy)
    for (int ix = 0; ix < 8; ++ix)
      text += std::to_string(100 + 5 * ix - 3 * iy + (ix + iy) % 2) +
              (ix == 7 ? "\n" : "\t");
  SurfaceSpec surface = with_file(SurfaceKind::measured, "map.txt", text);
  surface.length.reset();
  surface.points.reset();
  surface.edges = mechanics::Edges::mirror;

  const HeightMap map = build_surface(surface, 0);

  EXPECT_EQ(map.grid, (Grid{16, 8, 16e-6, 8e-6}));
  EXPECT_NEAR(mean_height(map), 0.0, 1e-24);
  EXPECT_NEAR(statistics(map).rms_height, 0.5e-9, 5e-22);
  surface.level = mechanics::Levelling::none;
  EXPECT_GT(statistics(build_surface(surface, 0)).rms_height, 1e-8);
}

// A perfect tilt that is removed by levelling leaves only the roundoff of its
// heights and is refused as flat; the same with 1 pm of roughness on 100 nm is
// accepted, and so is the tilt itself where it is not removed.
TEST(BuildSurface, RefusesATiltThatLevellingMakesFlat) {
  const auto tilted = [](double roughness) {
    std::ostringstream text;
    text.precision(17);
    text << "# Width: 8 um\n# Height: 8 um\n# Value units: nm\n";
    for (int iy = 0; iy < 16; ++iy)
      for (int ix = 0; ix < 16; ++ix)
        text << 100 + 0.3 * ix - 0.7 * iy + roughness * ((ix + iy) % 2)
             << (ix == 15 ? "\n" : "\t");
    SurfaceSpec surface =
        with_file(SurfaceKind::measured, "tilt.txt", text.str());
    surface.length.reset();
    surface.points.reset();
    surface.level = mechanics::Levelling::plane;
    return surface;
  };
  const SurfaceSpec flat = tilted(0.0);
  for (const mechanics::Edges edges :
       {mechanics::Edges::periodic, mechanics::Edges::mirror,
        mechanics::Edges::window}) {
    SurfaceSpec surface = flat;
    surface.edges = edges;
    const std::string message = tests::message_of<input::InputError>(
        [&] { build_surface(surface, 0); });
    EXPECT_TRUE(message.starts_with(flat.file +
                                    ": the surface is flat: after levelling"))
        << message;
  }
  SurfaceSpec left_in = flat;
  left_in.level = mechanics::Levelling::none;
  EXPECT_GT(statistics(build_surface(left_in, 0)).rms_height, 1e-9);
  EXPECT_NEAR(statistics(build_surface(tilted(1e-3), 0)).rms_height / 0.5e-12,
              1.0, 1e-3);
}

// The Hann window leaves 3/8 of the rms height and, at short waves, of the
// slope of a statistically homogeneous map; a mirrored map keeps both.
// Tolerance: the checkerboard has no scatter; its slope by differences is
// exact, and the window's own slope adds 4e-3 of it at 32 points.
TEST(BuildSurface, ReportsThePowerThatItsEdgesRemove) {
  std::string text = "# Width: 8 um\n# Height: 8 um\n# Value units: nm\n";
  for (int iy = 0; iy < 32; ++iy)
    for (int ix = 0; ix < 32; ++ix)
      text += std::to_string((ix + iy) % 2) + (ix == 31 ? "\n" : "\t");
  SurfaceSpec surface = with_file(SurfaceKind::measured, "edges.txt", text);
  surface.length.reset();
  surface.points.reset();

  surface.edges = mechanics::Edges::window;
  const EdgeEffect window = edge_effect(surface);
  surface.edges = mechanics::Edges::mirror;
  const EdgeEffect mirror = edge_effect(surface);

  EXPECT_NEAR(window.measured.rms_height, 0.5e-9, 1e-21);
  EXPECT_NEAR(window.measured.rms_slope, std::sqrt(2.0) * 1e-9 / 0.25e-6,
              1e-12);
  EXPECT_NEAR(window.pressed.rms_height / window.measured.rms_height, 0.375,
              1e-12);
  EXPECT_NEAR(window.pressed.rms_slope / window.measured.rms_slope, 0.375,
              0.01);
  EXPECT_NEAR(mirror.pressed.rms_height / mirror.measured.rms_height, 1.0,
              1e-12);
  EXPECT_NEAR(mirror.pressed.rms_slope / mirror.measured.rms_slope, 1.0, 0.02);
}

TEST(BuildSurface, NamesTheInvalidKey) {
  SurfaceSpec surface = self_affine();
  const auto build = [&] { build_surface(surface, 0); };

  surface.points = 40;
  EXPECT_EQ(tests::message_of<input::InputError>(build),
            "surface.points = 40, but must be >= 42 to resolve "
            "surface.wavevector_high = 1.25664e+07 1/m (a wavelength of 5e-07 "
            "m) over surface.length = 1e-05 m");
  surface.points.reset();
  EXPECT_EQ(tests::message_of<input::InputError>(build),
            "surface.points is missing");
  surface = self_affine();
  surface.length.reset();
  EXPECT_EQ(tests::message_of<input::InputError>(build),
            "surface.length is missing");
  surface = self_affine();
  surface.rms_height.reset();
  EXPECT_EQ(tests::message_of<input::InputError>(build),
            "surface.rms_height or surface.rms_slope is missing");
  surface.kind = SurfaceKind::spectrum;
  surface.file = "none.csv";
  EXPECT_EQ(tests::message_of<input::InputError>(build),
            "none.csv: there is no such file");
  surface.kind = SurfaceKind::sphere;
  EXPECT_THROW(formula_spectrum(surface), std::domain_error);
}

TEST(BuildSurface, ReportsATableBeyondTheGrid) {
  const SurfaceSpec surface =
      with_file(SurfaceKind::spectrum, "fine.csv", "1e6 1e-30\n1e9 1e-40\n");

  EXPECT_EQ(
      tests::message_of<input::InputError>([&] { build_surface(surface, 0); }),
      "surface.points = 64, but must be >= 3184 to resolve the last q of " +
          surface.file +
          " = 1e+09 1/m (a wavelength of 6.28319e-09 m) over surface.length = "
          "1e-05 m");
}

constexpr double length = 1e-5;
constexpr double rounding = 1e-14; // of heights, from two transforms

Grid square(int points) {
  return {points, points, length, length};
}

/// 2 nm rms height, waves of 1 to 20 periods.
SurfaceSpec rescaled() {
  SurfaceSpec surface = self_affine();
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
    SurfaceSpec surface = rescaled();
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
  const SurfaceSpec surface = rescaled();
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
  const SurfaceSpec surface = rescaled();

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
  SurfaceSpec surface = rescaled();
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

} // namespace asperity::surfaces::build_test
