// Tests of surfaces/maps/levelling.hpp: which trends are removed and what
// remains.
#include "base/maximum.hpp"
#include "surfaces/maps/levelling.hpp"
#include "surfaces/maps/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::surfaces::levelling_test {

using mechanics::Levelling;

/// A quadratic trend of the given coefficients [m] on a rectangle of odd and
/// even sides, with coordinates from one corner as in an instrument.
HeightMap trend(double tilt, double bow) {
  HeightMap map{{31, 24, 3e-6, 2e-6}, {}};
  for (int iy = 0; iy < 24; ++iy)
    for (int ix = 0; ix < 31; ++ix) {
      const double x = ix / 31.0;
      const double y = iy / 24.0;
      map.heights.push_back(5e-6 + tilt * (x - 0.7 * y) +
                            bow * (x * x - 0.4 * x * y + 0.8 * y * y));
    }
  return map;
}

double largest(const HeightMap& map) {
  EXPECT_FALSE(map.heights.empty());
  return largest_magnitude(map.heights);
}

// A trend of the removed degree vanishes. Tolerance: 20 eps of 5 um.
TEST(RemoveTrend, RemovesItsPolynomialExactly) {
  HeightMap plane = trend(1e-6, 0.0);
  HeightMap bow = trend(1e-6, 3e-7);

  remove_trend(plane, Levelling::plane);
  remove_trend(bow, Levelling::bow);

  EXPECT_LT(largest(plane), 2e-20);
  EXPECT_LT(largest(bow), 2e-20);
}

TEST(RemoveTrend, LeavesOtherTrends) {
  HeightMap none = trend(1e-6, 3e-7);
  HeightMap plane = trend(1e-6, 3e-7);

  remove_trend(none, Levelling::none);
  remove_trend(plane, Levelling::plane);

  EXPECT_NEAR(mean_height(none), 0.0, 1e-21);
  EXPECT_GT(largest(none), 5e-7); // the tilt is there
  EXPECT_GT(largest(plane), 5e-8);
  EXPECT_LT(largest(plane), 3e-7);
}

// The least-squares remainder is orthogonal to 1, x, y, x^2, x y, y^2, which
// defines it; x and y from the corner, by direct sums. Tolerance: 744 terms of
// 1e-8 m, some 10 eps of their sum.
TEST(RemoveTrend, LeavesALeastSquaresRemainder) {
  HeightMap map = trend(1e-6, 3e-7);
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    map.heights[i] += 1e-8 * std::sin(0.7 * static_cast<double>(i * i % 97));

  remove_trend(map, Levelling::bow);

  for (int power_x = 0; power_x <= 2; ++power_x)
    for (int power_y = 0; power_x + power_y <= 2; ++power_y) {
      double sum = 0.0;
      for (int iy = 0; iy < 24; ++iy)
        for (int ix = 0; ix < 31; ++ix)
          sum += map.heights[map.grid.index(ix, iy)] *
                 std::pow(ix / 31.0, power_x) * std::pow(iy / 24.0, power_y);
      EXPECT_NEAR(sum, 0.0, 1e-19) << power_x << " " << power_y;
    }
  EXPECT_GT(statistics(map).rms_height, 5e-9); // the roughness is there
}

TEST(RemoveTrend, TakesTheSmallestMaps) {
  HeightMap map{{2, 2, 1.0, 1.0}, {1.0, 2.0, 3.0, 5.0}};

  remove_trend(map, Levelling::plane);

  // The remainder of a plane through four corners is (a - b - c + d)/4.
  EXPECT_NEAR(map.heights[0], 0.25, 1e-15);
  EXPECT_NEAR(map.heights[1], -0.25, 1e-15);
  EXPECT_NEAR(map.heights[3], 0.25, 1e-15);
}

} // namespace asperity::surfaces::levelling_test
