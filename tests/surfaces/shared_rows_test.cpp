// Tests of the surfaces whose rows several ranks hold: heights, statistics and
// spectrum have the bits of one process. Tolerance: none.
#include "surfaces/build.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/maps/statistics.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace asperity::surfaces::shared_rows_test {

constexpr double length = 1e-5; // m
constexpr double unit = 2.0 * std::numbers::pi / length;

mechanics::SurfaceSpec rough(int points) {
  mechanics::SurfaceSpec surface;
  surface.length = length;
  surface.points = points;
  surface.seed = 7;
  surface.rms_height = 1e-9;
  surface.hurst = 0.8;
  surface.wavevector_low = unit;
  surface.wavevector_roll_off = 4 * unit;
  surface.wavevector_high = 60 * unit;
  return surface;
}

/// The variants of the specification that take other ways.
std::vector<mechanics::SurfaceSpec> variants() {
  mechanics::SurfaceSpec scaled = rough(134);
  scaled.amplitudes = mechanics::Amplitudes::gaussian;
  scaled.rescale = true;
  mechanics::SurfaceSpec by_slope = rough(160);
  by_slope.rms_height = {};
  by_slope.rms_slope = 0.01;
  by_slope.rescale = true;
  by_slope.form_radius = 1e-3;
  return {rough(160), rough(125), scaled, by_slope};
}

/// Unequal shares with even bounds.
std::vector<int> bounds_of(int points, int n) {
  std::vector<int> bounds{0};
  for (int r = 1; r < n; ++r)
    bounds.push_back(6 * r * r);
  bounds.push_back(points);
  return bounds;
}

void expect_equal(const Statistics& found, const Statistics& expected) {
  EXPECT_EQ(found.rms_height, expected.rms_height);
  EXPECT_EQ(found.rms_slope, expected.rms_slope);
  EXPECT_EQ(found.rms_curvature, expected.rms_curvature);
  EXPECT_EQ(found.skewness, expected.skewness);
  EXPECT_EQ(found.kurtosis, expected.kurtosis);
  EXPECT_EQ(found.highest, expected.highest);
  EXPECT_EQ(found.lowest, expected.lowest);
}

void expect_equal(const std::vector<Shell>& found,
                  const std::vector<Shell>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].wavevector, expected[i].wavevector);
    EXPECT_EQ(found[i].mean_square_height, expected[i].mean_square_height);
    EXPECT_EQ(found[i].modes, expected[i].modes);
  }
}

TEST(SharedSurface, HasTheBitsOfOneProcess) {
  for (const mechanics::SurfaceSpec& surface : variants()) {
    const HeightMap whole = build_surface(surface, 3);
    const Statistics numbers = statistics(whole);
    const std::vector<Shell> shells = spectral_shells(whole);
    for (int n = 1; n <= 4; ++n)
      tests::on_thread_ranks(n, [&](RankGroup& ranks) {
        const SharedRows rows(whole.grid, ranks, bounds_of(*surface.points, n));
        const std::vector<double> own =
            build_rows(surface, 3, rows, {}, n % 2 + 1);
        ASSERT_EQ(own.size(), rows.size());
        EXPECT_TRUE(std::ranges::equal(
            own, std::span(whole.heights)
                     .subspan(whole.grid.index(0, rows.first()), own.size())));
        expect_equal(statistics(rows, own, 2), numbers);
        expect_equal(spectral_shells(rows, own, 2), shells);
      });
  }
}

// The factor of a rescaled surface comes from another grid, which is also
// divided.
TEST(SharedSurface, HasTheBitsOfOneProcessAtAMagnification) {
  for (const mechanics::SurfaceSpec& surface : variants()) {
    const int points = *surface.points;
    const HeightMap whole = build_surface_on(
        surface, 1, {points, points, length, length}, 20 * unit);
    tests::on_thread_ranks(3, [&](RankGroup& ranks) {
      const SharedRows rows(whole.grid, ranks, bounds_of(points, 3));
      const std::vector<double> own = build_rows(surface, 1, rows, 20 * unit);
      EXPECT_TRUE(std::ranges::equal(
          own, std::span(whole.heights)
                   .subspan(whole.grid.index(0, rows.first()), own.size())));
    });
  }
}

// The shells by columns are those of the modes row by row. Tolerance: roundoff
// of sums of at most 10^4 terms.
TEST(SharedSurface, HasTheShellsOfAllModes) {
  for (const Grid& grid :
       {Grid{24, 30, 1e-5, 2e-5}, Grid{15, 21, 1e-5, 1e-5}}) {
    HeightMap map{grid, std::vector<double>(grid.size())};
    for (std::size_t i = 0; i < map.heights.size(); ++i)
      map.heights[i] = static_cast<double>(i * i % 101);
    const std::vector<Shell> found = spectral_shells(map);
    const std::vector<Shell> expected = ModeShells(grid).of(map);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_NEAR(found[i].wavevector, expected[i].wavevector,
                  1e-12 * expected[i].wavevector);
      EXPECT_NEAR(found[i].mean_square_height, expected[i].mean_square_height,
                  1e-12 * expected[i].mean_square_height);
      EXPECT_EQ(found[i].modes, expected[i].modes);
    }
  }
}

TEST(SharedSurface, RefusesAnotherGridAndASmoothedShape) {
  mechanics::SurfaceSpec wave = rough(160);
  wave.kind = mechanics::SurfaceKind::wave_1d;
  wave.amplitude = 1e-9;
  wave.wavelength = length;
  tests::on_thread_ranks(2, [&](RankGroup& ranks) {
    const SharedRows finer({320, 320, length, length}, ranks, {0, 40, 320});
    EXPECT_THROW(build_rows(rough(160), 0, finer), std::domain_error);
    const SharedRows rows({160, 160, length, length}, ranks, {0, 40, 160});
    EXPECT_THROW(build_rows(wave, 0, rows, 20 * unit), std::domain_error);
  });
}

} // namespace asperity::surfaces::shared_rows_test
