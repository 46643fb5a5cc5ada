// Tests of theory/persson/highest_peak.hpp against random fields, and in the
// limit of extreme-value theory.
#include "surfaces/build.hpp"
#include "surfaces/maps/statistics.hpp"
#include "theory/persson/highest_peak.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "spectra.hpp"

namespace asperity::theory::highest_peak_test {

constexpr double side = 104e-9;
// The roughness begins at the longest wave of the cell.
const SelfAffine surface{.low = 2.0 * std::numbers::pi / side};
const ProfileMoments moments =
    surface.with_rms_height(1e-9).spectrum().profile_moments();

mechanics::SurfaceSpec spec_of(double length, int points) {
  mechanics::SurfaceSpec spec;
  spec.kind = mechanics::SurfaceKind::self_affine;
  spec.length = length;
  spec.points = points;
  spec.seed = 5;
  spec.rms_height = 1e-9;
  spec.hurst = surface.hurst;
  spec.wavevector_low = surface.low;
  spec.wavevector_roll_off = surface.roll_off;
  spec.wavevector_high = surface.high;
  return spec;
}

// Euler's characteristic of the nodes above a height, with the edges and faces
// of the periodic grid between them: patches minus holes.
int patches_less_holes(const surfaces::HeightMap& map, double height) {
  const int n = map.grid.points_x;
  const auto above = [&](int ix, int iy) {
    return map.heights[map.grid.index(ix % n, iy % n)] > height;
  };
  int count = 0;
  for (int iy = 0; iy < n; ++iy)
    for (int ix = 0; ix < n; ++ix) {
      if (!above(ix, iy))
        continue;
      const bool right = above(ix + 1, iy);
      const bool up = above(ix, iy + 1);
      count += 1 - right - up + (right && up && above(ix + 1, iy + 1));
    }
  return count;
}

// n(x) is the mean of the counts on random surfaces. Tolerance: three standard
// errors, and 5 % for the corners of the grid.
TEST(PeaksAbove, ArePatchesLessHolesOfRandomSurfaces) {
  const int n = 64;
  const mechanics::SurfaceSpec spec = spec_of(side, 128);
  for (const double height : {0.0, 1.0, 2.0}) {
    double sum = 0.0;
    double squares = 0.0;
    for (int r = 0; r < n; ++r) {
      const surfaces::HeightMap map = surfaces::build_surface(spec, r);
      const double rms_height = surfaces::statistics(map).rms_height;
      const int count = patches_less_holes(map, height * rms_height);
      sum += count;
      squares += count * count;
    }
    const double mean = sum / n;
    const double error = std::sqrt((squares / n - mean * mean) / n);

    EXPECT_NEAR(mean, peaks_above(moments, side * side, height),
                3.0 * error + 0.05 * mean);
  }
}

// Verifies the mean over random surfaces of three and six roll-off lengths per
// side. Tolerance: three standard errors of the sample; with ten nodes in the
// shortest wave the grid misses less than 1 % of a peak.
TEST(ExpectedHighest, IsThatOfRandomSurfaces) {
  for (const int sides : {1, 2}) {
    const int n = sides == 1 ? 128 : 32;
    const mechanics::SurfaceSpec spec = spec_of(sides * side, sides * 128);
    double sum = 0.0;
    double squares = 0.0;
    for (int r = 0; r < n; ++r) {
      const auto numbers =
          surfaces::statistics(surfaces::build_surface(spec, r));
      const double highest = numbers.highest / numbers.rms_height;
      sum += highest;
      squares += highest * highest;
    }
    const double mean = sum / n;
    const double error = std::sqrt((squares / n - mean * mean) / n);

    const double expected =
        expected_highest(moments, sides * sides * side * side);

    EXPECT_NEAR(mean, expected, 3.0 * error + 0.01 * mean) << error;
  }
}

// For a very large area it is Gumbel's: the height x above which one peak is
// expected, plus Euler's gamma over the decrease of ln n there, x - 1/x.
// Tolerance: the curvature of ln n, -1 - 1/x^2, over that decrease cubed, with
// gamma^2 + pi^2/6 = 2 for the mean square.
TEST(ExpectedHighest, TendsToGumbels) {
  const double area = 1e12 * moments.height / moments.slope;
  double one = 8.0; // peaks_above() = 1, by Newton's method on ln n
  for (int i = 0; i < 50; ++i)
    one += std::log(peaks_above(moments, area, one)) / (one - 1.0 / one);

  const double fall = one - 1.0 / one;
  const double gumbel = one + std::numbers::egamma / fall;

  EXPECT_NEAR(expected_highest(moments, area), gumbel,
              1.1 * std::pow(fall, -3.0));
}

// Only m_0/m_2 and the area matter, and the peak of a larger surface is higher.
TEST(ExpectedHighest, GrowsWithTheSide) {
  const double here = expected_highest(moments, side * side);

  EXPECT_NEAR(expected_highest({4.0 * moments.height, 4.0 * moments.slope, 0.0},
                               side * side),
              here, 1e-9);
  EXPECT_GT(expected_highest(moments, 4.0 * side * side), here + 0.3);
}

TEST(ExpectedHighest, RefusesWhatIsTooSmall) {
  EXPECT_THROW(expected_highest(moments, 0.0), std::domain_error);
  EXPECT_THROW(expected_highest(moments, 1e-20), std::domain_error);
  EXPECT_THROW(peaks_above({0.0, 1.0, 1.0}, 1.0, 3.0), std::domain_error);
}

} // namespace asperity::theory::highest_peak_test
