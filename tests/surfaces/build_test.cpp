// Tests of surfaces/build.hpp: each kind of surface of a case is built.
#include "input/input_error.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/measured_map.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "tests/message_of.hpp"

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

TEST(BuildSurface, MakesTheExactShapes) {
  SurfaceSpec surface = self_affine();
  surface.amplitude = 1e-8;
  surface.wavelength = 5e-6;
  surface.radius = 1e-3;

  surface.kind = SurfaceKind::wave_1d;
  EXPECT_NEAR(statistics(build_surface(surface, 0)).rms_height,
              1e-8 / std::sqrt(2.0), 1e-21);
  surface.kind = SurfaceKind::wave_2d;
  EXPECT_NEAR(statistics(build_surface(surface, 0)).rms_height, 0.5e-8, 1e-21);
  surface.kind = SurfaceKind::sphere;
  const HeightMap map = build_surface(surface, 0);
  EXPECT_NEAR(map.heights[map.grid.index(32, 32)], statistics(map).highest,
              1e-22);
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

} // namespace asperity::surfaces::build_test
