// Tests of surfaces/maps/edges.hpp: the effect of window and mirror on the
// power.
#include "base/fourier.hpp"
#include "surfaces/maps/edges.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/maps/shells.hpp"
#include "surfaces/maps/statistics.hpp"
#include "surfaces/realization.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace asperity::surfaces::edges_test {

using mechanics::Edges;

constexpr Grid grid{64, 64, 1e-5, 1e-5};
constexpr double unit = 2.0 * std::numbers::pi / 1e-5;

HeightMap rough(int realization) {
  const SelfAffineShape shape{0.7, 4 * unit, 6 * unit, 25 * unit};
  return realize(SelfAffineSpectrum::with_rms_height(shape, 1e-9).isotropic(),
                 grid, {11, realization});
}

TEST(Edges, PeriodicLeavesTheMapAsItIs) {
  const HeightMap map = rough(0);

  const HeightMap same = with_edges(map, Edges::periodic);

  EXPECT_EQ(same.grid, map.grid);
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    EXPECT_NEAR(same.heights[i], map.heights[i], 1e-24);
}

// <sin^4> = 3/8, in two directions. Tolerance: roundoff of 64 terms.
TEST(HannWindow, HasItsKnownPower) {
  EXPECT_NEAR(hann_power(grid), 9.0 / 64.0, 1e-15);
  EXPECT_NEAR(hann_power({5, 3, 1.0, 1.0}), 9.0 / 64.0, 1e-15);
}

// Rms height and slope of the windowed map over sqrt(hann_power) are those of
// the surface, in the mean over random phases. The heights are exactly unbiased
// (the window has no waves beyond the first); the slope has a bias of the
// relative order (q_window/q)^2 = 1/40 at most from the window's own slope.
// Statistics: 100 realisations, 4 standard errors found from them.
TEST(HannWindow, HasThePowerThatItsCorrectionRestores) {
  const int count = 100;
  double sum = 0.0;
  double sum_of_squares = 0.0;
  double slope = 0.0;
  for (int realization = 0; realization < count; ++realization) {
    const HeightMap map = rough(realization);
    const Statistics before = statistics(map);
    const Statistics after = statistics(with_edges(map, Edges::window));
    const double ratio =
        std::pow(after.rms_height / before.rms_height, 2) / hann_power(grid);
    sum += ratio / count;
    sum_of_squares += ratio * ratio / count;
    slope += std::pow(after.rms_slope / before.rms_slope, 2) /
             hann_power(grid) / count;
  }

  const double standard_error =
      std::sqrt((sum_of_squares - sum * sum) / (count - 1));
  EXPECT_LT(standard_error, 0.02);
  EXPECT_NEAR(sum, 1.0, 4.0 * standard_error);
  EXPECT_NEAR(slope, 1.0, 4.0 * standard_error + 0.025);
}

// A constant is not roughness, and neither is a step at the periodic boundary.
// The mean that is subtracted is weighted by the window; otherwise a
// second-order form would raise the border.
TEST(HannWindow, IgnoresAnOffsetAndVanishesAtTheBoundary) {
  HeightMap map = rough(0);
  for (int iy = 0; iy < 64; ++iy)
    for (int ix = 0; ix < 64; ++ix)
      map.heights[grid.index(ix, iy)] += 1e-9 * std::pow(ix / 32.0 - 1.0, 2);
  const HeightMap plain = with_edges(map, Edges::window);
  for (double& height : map.heights)
    height += 1e-6;
  const HeightMap lifted = with_edges(map, Edges::window);

  for (std::size_t i = 0; i < map.heights.size(); ++i)
    EXPECT_NEAR(lifted.heights[i], plain.heights[i], 1e-20); // eps of 1 um
  EXPECT_NEAR(mean_height(plain), 0.0, 1e-24);
  for (int i = 0; i < grid.points_x; ++i) // w(1/2 node) = sin^2(pi/128) = 6e-4
    EXPECT_LT(std::abs(plain.heights[grid.index(i, 0)]), 6e-4 * 5e-9);
}

// The window is centred on the map: an odd map stays odd about the centre, and
// a node has the weight of its position. Tolerance: the means of 48 heights up
// to 8.5, 50 eps * 8.5 = 1e-13.
TEST(HannWindow, IsCentredOnTheMap) {
  HeightMap ramp{{8, 6, 1.0, 1.0}, {}};
  for (int i = 0; i < 48; ++i)
    ramp.heights.push_back(i % 8 - 3.5 + 2.0 * (i / 8 - 2.5));

  const HeightMap map = with_edges(ramp, Edges::window);

  for (std::size_t i = 0; i < 48; ++i)
    EXPECT_NEAR(map.heights[i], -map.heights[47 - i], 1e-13);
  // The value at node (2, 1): sin^2(pi 2.5/8) sin^2(pi 1.5/6) times its height.
  const double weight = std::pow(std::sin(2.5 * std::numbers::pi / 8), 2) / 2;
  EXPECT_NEAR(map.heights[10], weight * (-1.5 - 3.0), 1e-13);
}

TEST(Mirror, HasNoStepAtTheBoundaryAndTheHeightsOfTheMap) {
  HeightMap map = rough(0);
  for (int iy = 0; iy < 64; ++iy)
    for (int ix = 0; ix < 64; ++ix)
      map.heights[grid.index(ix, iy)] += 1e-9 * ix; // a step of 64 nm
  const double mean = mean_height(map);

  const HeightMap twice = with_edges(map, Edges::mirror);

  EXPECT_EQ(twice.grid, (Grid{128, 128, 2e-5, 2e-5}));
  for (int iy = 0; iy < 128; ++iy) {
    EXPECT_EQ(twice.heights[twice.grid.index(127, iy)],
              twice.heights[twice.grid.index(0, iy)]);
    EXPECT_EQ(twice.heights[twice.grid.index(iy, 64)],
              twice.heights[twice.grid.index(iy, 63)]);
  }
  EXPECT_NEAR(twice.heights[twice.grid.index(70, 100)],
              map.heights[grid.index(57, 27)] - mean, 1e-22);
  EXPECT_NEAR(statistics(twice).rms_height / statistics(map).rms_height, 1.0,
              1e-13);
}

// The mirrored map is even about the point half a node before node 0, so that
// its modes are real except for that shift, and their power sums to <h^2> of
// the map. Tolerance: roundoff against h_rms = 1 nm.
TEST(Mirror, HasARealSpectrumWithThePowerOfTheMap) {
  const HeightMap map = rough(3);
  const HeightMap twice = with_edges(map, Edges::mirror);
  std::vector<std::complex<double>> modes(twice.grid.half_spectrum_size());
  RealFourier(twice.grid).forward(twice.heights, modes);

  std::size_t at = 0;
  for (int jy = 0; jy < 128; ++jy)
    for (int jx = 0; jx <= 64; ++jx, ++at) {
      const double shift = std::numbers::pi * (jx + jy) / 128.0;
      const auto coefficient = modes[at] / 16384.0 * std::polar(1.0, -shift);
      EXPECT_NEAR(coefficient.imag(), 0.0, 1e-23);
    }
  double power = 0.0;
  for (const Shell& shell : spectral_shells(twice))
    power += shell.mean_square_height;
  EXPECT_NEAR(std::sqrt(power) / statistics(map).rms_height, 1.0, 1e-13);
}

} // namespace asperity::surfaces::edges_test
