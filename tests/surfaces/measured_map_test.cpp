// Tests of surfaces/measured_map.hpp: the order of the corrections, the limit
// of missing points, and the messages about them.
#include "input/input_error.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/measured_map.hpp"
#include "surfaces/realization.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace asperity::surfaces::measured_map_test {

/// A rough map of 20 x 20 points of 1 um; `change` replaces single words.
mechanics::SurfaceSpec surface_of(const std::string& name,
                                  const std::string& first = "0.5",
                                  const std::string& other = "0.25") {
  mechanics::SurfaceSpec surface;
  surface.kind = mechanics::SurfaceKind::measured;
  surface.file = testing::TempDir() + "asperity_measured_map_" + name + ".txt";
  surface.length = 20e-6;
  surface.height_unit = 1e-9;
  surface.level = mechanics::Levelling::none;
  std::ofstream file(surface.file);
  for (int iy = 0; iy < 20; ++iy)
    for (int ix = 0; ix < 20; ++ix)
      file << (ix + iy == 0                ? first
               : ix == 10 && iy == 10      ? other
               : (ix * 3 + iy * 5) % 7 > 3 ? "0.75"
                                           : "-0.5")
           << (ix == 19 ? '\n' : ' ');
  return surface;
}

std::string refusal_of(const mechanics::SurfaceSpec& surface) {
  return tests::message_of<input::InputError>([&] { measured_map(surface); });
}

TEST(MeasuredMap, FillsMissingPointsUpToTheLimit) {
  mechanics::SurfaceSpec surface = surface_of("missing", "nan", "BAD");
  const MeasuredMap measured = measured_map(surface);
  EXPECT_EQ(measured.missing, 2U);
  EXPECT_EQ(description_of(measured),
            "own reader of plain matrices; 2 missing point(s) (0.5 %) filled");
  surface.max_missing = 0.004;
  EXPECT_EQ(refusal_of(surface),
            surface.file +
                ": 2 of 400 points are missing, a fraction of 0.005, but at "
                "most surface.max_missing = 0.004 may be filled; crop the map "
                "or raise that limit");
  surface.max_missing = 0.05;
  surface.fill = mechanics::Filling::none;
  EXPECT_EQ(refusal_of(surface),
            surface.file + ": 2 of 400 points are missing (0.5 %), but with "
                           "surface.fill = \"none\" none must be");
}

// A result with such heights would be refused by every reader.
TEST(MeasuredMap, HeightsAndSidesHaveTheLimitsOfLengths) {
  const std::string limits = " m, but lengths other than 0 must be between "
                             "1e-16 and 1e+16 m; check their unit";
  mechanics::SurfaceSpec huge = surface_of("huge", "1e200", "0");
  huge.missing_value = -9999.0; // all numbers are heights
  EXPECT_EQ(refusal_of(huge), huge.file + ": heights of 1e+191" + limits);
  mechanics::SurfaceSpec large = surface_of("large", "1e49", "0");
  large.missing_value = -9999.0;
  EXPECT_EQ(refusal_of(large), large.file + ": heights of 1e+40" + limits);
  mechanics::SurfaceSpec wide = surface_of("wide", "1", "0");
  wide.length = 1e17;
  EXPECT_EQ(refusal_of(wide), wide.file + ": a side of 1e+17" + limits);
  mechanics::SurfaceSpec low = surface_of("low", "1", "0");
  low.height_unit = 1e-40;
  EXPECT_NE(refusal_of(low).find("heights of at most"), std::string::npos);
}

/// The heights of a map of 24 x 16 points of 1 um: waves of these numbers of
/// halves in a side, as its mirror images or its period continues them.
HeightMap waves(bool is_periodic, const std::vector<int>& halves) {
  HeightMap map{{24, 16, 24e-6, 16e-6}, {}};
  for (int iy = 0; iy < 16; ++iy)
    for (int ix = 0; ix < 24; ++ix) {
      double height = 0.0;
      for (const int k : halves) {
        const double at = (ix + (is_periodic ? 0.0 : 0.5)) / 24.0;
        height += 1e-8 * std::cos(std::numbers::pi * k * at);
      }
      map.heights.push_back(height);
    }
  return map;
}

mechanics::SurfaceSpec written(const HeightMap& map, mechanics::Edges edges) {
  mechanics::SurfaceSpec surface = surface_of("waves");
  surface.length = map.grid.length_x;
  surface.height_unit = 1.0;
  surface.edges = edges;
  std::ofstream file(surface.file);
  file.precision(17);
  const auto columns = static_cast<std::size_t>(map.grid.points_x);
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    file << map.heights[i] << ((i + 1) % columns == 0 ? '\n' : ' ');
  return surface;
}

// Waves of a map that is not periodic are those of its mirror images, where a
// half wave fits in a side: 6 halves of 24 um are 8 um long, 7 are shorter.
// Tolerance: roundoff of two transforms.
TEST(MeasuredMap, LosesTheWavesBelowItsCutOff) {
  for (const bool is_periodic : {true, false}) {
    const std::vector<int> kept =
        is_periodic ? std::vector{2, 6} : std::vector{1, 6};
    std::vector<int> all = kept;
    all.push_back(is_periodic ? 8 : 7);
    const HeightMap expected = waves(is_periodic, kept);
    for (const bool has_images : {true, false}) {
      mechanics::SurfaceSpec surface = written(
          waves(is_periodic, all),
          is_periodic ? mechanics::Edges::periodic : mechanics::Edges::free);
      surface.cut_off = 8e-6;
      surface.has_images = has_images;

      const HeightMap found = levelled_map(surface);

      ASSERT_EQ(found.heights.size(), expected.heights.size());
      for (std::size_t i = 0; i < found.heights.size(); ++i)
        ASSERT_NEAR(found.heights[i], expected.heights[i], 1e-20) << i;
    }
  }
}

// Waves and white noise have the same density at a wavelength of 6 um: there
// the map is cut off, to a ring of 20 per decade, and nowhere without noise.
TEST(MeasuredMap, LosesItsNoiseFloor) {
  constexpr double q = 2.0 * std::numbers::pi * 1e6; // per um of wavelength
  const SelfAffineSpectrum spectrum = SelfAffineSpectrum::with_rms_height(
      {0.8, q / 128.0, q / 32.0, q / 2.1}, 1e-8);
  HeightMap map =
      realize(spectrum.isotropic(), {128, 128, 128e-6, 128e-6}, {3, 0});
  mechanics::SurfaceSpec surface = written(map, mechanics::Edges::periodic);
  const HeightMap clean = levelled_map(surface);
  surface.cut_off = 0.0;
  EXPECT_EQ(measured_map(surface).cut_off, 0.0);
  EXPECT_EQ(levelled_map(surface).heights, clean.heights);

  std::mt19937 random(7);
  std::normal_distribution<double> noise(
      0.0, std::sqrt(spectrum(q / 6.0)) * 2.0 * std::numbers::pi / 1e-6);
  for (double& height : map.heights)
    height += noise(random);
  surface = written(map, mechanics::Edges::periodic);
  surface.cut_off = 0.0;
  const MeasuredMap found = measured_map(surface);
  EXPECT_NEAR(found.cut_off, 6e-6, 1e-6);
  surface.cut_off = found.cut_off;
  EXPECT_EQ(levelled_map(surface).heights, found.map.heights);
}

TEST(MeasuredMap, RefusesACutOffAboveItsSides) {
  mechanics::SurfaceSpec surface = surface_of("cut");
  surface.cut_off = 21e-6;
  EXPECT_EQ(refusal_of(surface),
            surface.file + ": surface.cut_off = 2.1e-05 m, but must be at most "
                           "the longer side of the map, 2e-05 m");
}

/// A message about a number that marks missing points.
std::string mark_message(const mechanics::SurfaceSpec& surface,
                         const std::string& points, const std::string& number,
                         const std::string& reason) {
  return surface.file + ": " + points + " point(s) have the number " + number +
         ", which " + reason +
         " and probably marks missing points; --missing-value " + number +
         " takes it for that, and another value, such as 1e99, takes all "
         "numbers for heights";
}

// The numbers are those of Surfer (1.70141e38), geographic grids (-9999),
// 16-bit integers, and single precision.
TEST(MeasuredMap, RefusesNumbersThatMarkMissingPoints) {
  for (const char* const number :
       {"-9999", "-32768", "32767", "65535", "-99999", "-2147483648"}) {
    const mechanics::SurfaceSpec surface = surface_of("mark", number, number);
    EXPECT_EQ(refusal_of(surface),
              mark_message(surface, "2",
                           number == std::string("-2147483648")
                               ? "-2.147484e+09"
                               : number,
                           "is far from all others"));
  }
  for (const char* const number :
       {"1.70141e+38", "1e+30", "-3.402823e+38", "1e+20"}) {
    const mechanics::SurfaceSpec surface = surface_of("mark", "0.5", number);
    EXPECT_EQ(refusal_of(surface),
              mark_message(surface, "1", number, "is larger than any height"));
  }
}

TEST(MeasuredMap, TakesTheNumberOfTheCaseForMissingPoints) {
  mechanics::SurfaceSpec surface = surface_of("value", "-9999", "-9999.0");
  surface.missing_value = -9999.0;
  EXPECT_EQ(measured_map(surface).missing, 2U);
  // Surfer's number is written with more digits than the key.
  surface = surface_of("surfer", "1.70141183460469e+38", "0.5");
  surface.missing_value = 1.70141e38;
  EXPECT_EQ(measured_map(surface).missing, 1U);
  surface.missing_value = 1e99; // the number is a height
  EXPECT_NE(refusal_of(surface).find("heights of 1.7e+29 m"),
            std::string::npos);
}

// The least number of a map whose other numbers are near it is a height.
TEST(MeasuredMap, TakesUsualMarksWithinTheRangeForHeights) {
  const mechanics::SurfaceSpec surface = surface_of("near");
  std::ofstream map(surface.file);
  for (int iy = 0; iy < 20; ++iy)
    for (int ix = 0; ix < 20; ++ix)
      map << -9999 + 10 * ix + iy * iy << (ix == 19 ? '\n' : ' ');
  map.close();
  EXPECT_EQ(measured_map(surface).missing, 0U);
}

// The map is cropped first, so that missing points outside the window do not
// count.
TEST(MeasuredMap, CropsFirst) {
  mechanics::SurfaceSpec surface = surface_of("crop", "nan", "BAD");
  surface.crop = mechanics::MapWindow{1e-6, 0.0, 0.0, 8e-6};
  const MeasuredMap measured = measured_map(surface);
  EXPECT_EQ(measured.missing, 0U);
  EXPECT_EQ(measured.map.grid.points_x, 19);
  EXPECT_EQ(measured.map.grid.points_y, 8);
  surface.crop->length_x = 1.0;
  EXPECT_NE(refusal_of(surface).find("along x is not inside the map of 2e-05"),
            std::string::npos);
}

TEST(MeasuredMap, ReplacesSpikes) {
  mechanics::SurfaceSpec surface = surface_of("spikes", "0.5", "500");
  surface.spikes = 10.0;
  const MeasuredMap measured = measured_map(surface);
  EXPECT_EQ(measured.spikes, 1U);
  for (const double height : measured.map.heights)
    EXPECT_LT(height, 1e-9);
  EXPECT_EQ(description_of(measured),
            "own reader of plain matrices; 1 spike(s) (0.25 %) replaced");
}

TEST(MeasuredMap, RemovesASphere) {
  mechanics::SurfaceSpec surface = surface_of("level");
  surface.level = mechanics::Levelling::sphere;
  EXPECT_EQ(measured_map(surface).map.heights.size(), 400U);
}

} // namespace asperity::surfaces::measured_map_test
