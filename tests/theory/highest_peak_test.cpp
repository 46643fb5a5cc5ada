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
