// Tests of surfaces/assumptions.hpp: known fractions of known spectra, and an
// indicator that detects offsets of scan lines and nothing else.
#include "surfaces/assumptions.hpp"
#include "surfaces/build.hpp"
#include "surfaces/maps/edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace asperity::surfaces::assumptions_test {

/// cos along x with n waves in 64 points, amplitude 1 nm.
HeightMap wave(int n) {
  HeightMap map{{64, 48, 1e-6, 0.75e-6}, {}};
  for (int iy = 0; iy < 48; ++iy)
    for (int ix = 0; ix < 64; ++ix)
      map.heights.push_back(1e-9 *
                            std::cos(2.0 * std::numbers::pi * n * ix / 64.0));
  return map;
}

HeightRows rows_of(const HeightMap& map) {
  return [&map](const auto& take) { take(map.heights); };
}

double unresolved_share(const HeightMap& map) {
  return unresolved_slope_share(map.grid, rows_of(map));
}

double offset_ratio(const HeightMap& map) {
  return line_offset_ratio(map.grid, rows_of(map));
}

// A wave of four nodes is resolved and one of 64/17 nodes is not; for both at
// equal height the unresolved fraction is that of q^2. Tolerance: roundoff of a
// transform.
TEST(UnresolvedSlope, CountsWavesOfFewerThanFourNodes) {
  HeightMap both = wave(16);
  const HeightMap shorter = wave(17);
  for (std::size_t i = 0; i < both.heights.size(); ++i)
    both.heights[i] += shorter.heights[i];

  EXPECT_LT(unresolved_share(wave(16)), 1e-20);
  EXPECT_NEAR(unresolved_share(shorter), 1.0, 1e-14);
  EXPECT_NEAR(unresolved_share(both), 17.0 * 17.0 / (16.0 * 16.0 + 17.0 * 17.0),
              1e-14);
  EXPECT_TRUE(std::isnan(unresolved_share(wave(0))));
}

HeightMap white_noise(const Grid& grid, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> height(0.0, 1e-9);
  HeightMap map{grid, std::vector<double>(grid.size())};
  for (double& one : map.heights)
    one = height(random);
  return map;
}

// For white noise the fraction is 1 - (pi/32)/(8/3), int q^2 over the disc of
// half the Nyquist wavevector against that over the square of all wavevectors.
// Tolerance: three standard errors of the 256^2 modes, and 1 % for the modes on
// the boundary of the disc.
TEST(UnresolvedSlope, OfWhiteNoiseIsThatOfTheSquare) {
  EXPECT_NEAR(unresolved_share(white_noise({256, 256, 1.0, 1.0}, 1)),
              1.0 - std::numbers::pi / 32.0 / (8.0 / 3.0), 0.01);
}

mechanics::SurfaceSpec self_affine(double hurst, int points) {
  mechanics::SurfaceSpec surface;
  surface.kind = mechanics::SurfaceKind::self_affine;
  surface.length = 1e-5;
  surface.points = points;
  surface.seed = 3;
  surface.rms_height = 2e-9;
  surface.hurst = hurst;
  surface.wavevector_low = 2.0 * std::numbers::pi / 1e-5;
  surface.wavevector_roll_off = 4.0 * surface.wavevector_low;
  surface.wavevector_high = (points / 2 - 1) * surface.wavevector_low;
  surface.amplitudes = mechanics::Amplitudes::gaussian;
  return surface;
}

// For an isotropic Gaussian surface it is within a factor of two of 1, for
// every realisation and any H.
TEST(LineOffset, IsOneOfAnIsotropicSurface) {
  for (const double hurst : {0.3, 0.8, 1.0})
    for (int realization = 0; realization < 20; ++realization) {
      const double ratio =
          offset_ratio(build_surface(self_affine(hurst, 128), realization));
      EXPECT_GT(ratio, 0.5) << hurst << ", " << realization;
      EXPECT_LT(ratio, 2.0) << hurst << ", " << realization;
    }
}

// Offsets of the lines along x raise it above 1, those along y lower it below
// 1, by the ratio of their contributions: lines of 128 nodes with offsets of
// twice their own scatter. A tilt or a second-order form changes nothing.
TEST(LineOffset, DetectsShiftedLines) {
  HeightMap map = build_surface(self_affine(0.8, 128), 0);
  HeightMap turned = map;
  std::mt19937 random(1);
  std::normal_distribution<double> offset(0.0, 1e-9);
  for (int iy = 0; iy < 128; ++iy) {
    const double shift = offset(random);
    for (int ix = 0; ix < 128; ++ix) {
      map.heights[map.grid.index(ix, iy)] += shift;
      turned.heights[map.grid.index(iy, ix)] += shift;
    }
  }
  const double ratio = offset_ratio(map);
  EXPECT_GT(ratio, 5.0);
  EXPECT_LT(offset_ratio(turned), 0.2);

  for (int iy = 0; iy < 128; ++iy)
    for (int ix = 0; ix < 128; ++ix)
      map.heights[map.grid.index(ix, iy)] += 1e-7 * iy + 3e-7 * ix;
  EXPECT_NEAR(offset_ratio(map) / ratio, 1.0, 1e-6);
  EXPECT_TRUE(std::isnan(offset_ratio({{2, 2, 1.0, 1.0}, {0, 1, 2, 3}})));
  EXPECT_TRUE(std::isnan(offset_ratio(wave(3))));
}

// Heights of 1 nm beside an offset of 10 mm, in single precision as a file has
// them: the spacing of such numbers there is 2^-30 m. A tilt is removed after
// that. The same heights in double precision have no step.
TEST(HeightStep, IsThatOfSinglePrecisionBesideAnOffset) {
  HeightMap map = white_noise({64, 64, 1e-6, 1e-6}, 3);
  EXPECT_EQ(height_step(map.grid, rows_of(map), 1e-9), 0.0);
  for (std::size_t i = 0; i < map.heights.size(); ++i) {
    const auto stored = static_cast<float>(map.heights[i] + 0.01);
    map.heights[i] = static_cast<double>(stored) - 0.01 +
                     1e-11 * static_cast<double>(i % 64);
  }

  EXPECT_NEAR(height_step(map.grid, rows_of(map), 1e-9), std::pow(2.0, -30),
              1e-6 * std::pow(2.0, -30));
}

// The plane is removed in both directions.
TEST(RmsAboutPlane, DoesNotContainATilt) {
  const HeightMap noise = white_noise({40, 30, 1.0, 1.0}, 5);
  HeightMap tilted = noise;
  for (int iy = 0; iy < 30; ++iy)
    for (int ix = 0; ix < 40; ++ix)
      tilted.heights[noise.grid.index(ix, iy)] += 1e-7 * (2 * ix - 3 * iy);

  const double rough = rms_about_plane(noise.grid, rows_of(noise));
  EXPECT_NEAR(rough, 1e-9, 0.1e-9);
  EXPECT_NEAR(rms_about_plane(tilted.grid, rows_of(tilted)), rough,
              1e-6 * rough);
}

// A flat first row is no sign of mirror images: one node of 1 nm far from it.
// Tolerance: the mean and the plane take less than 1 % of its square.
TEST(RmsAboutPlane, IsThatOfAllRowsBelowAFlatOne) {
  HeightMap map{{40, 30, 1.0, 1.0}, std::vector<double>(1200, 0.0)};
  map.heights[map.grid.index(30, 20)] = 1e-9;
  EXPECT_NEAR(rms_about_plane(map.grid, rows_of(map)), 1e-9 / std::sqrt(1200.0),
              0.01e-9 / std::sqrt(1200.0));
}

} // namespace asperity::surfaces::assumptions_test
