// Tests of surfaces/analysis: height_parameters.hpp and local_differences.hpp.
#include "surfaces/analysis/height_parameters.hpp"
#include "surfaces/analysis/local_differences.hpp"
#include "surfaces/analysis/surface_analysis.hpp"
#include "surfaces/maps/exact_shapes.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/realization.hpp"

#include <boost/math/distributions/normal.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace asperity::surfaces::surface_parameters_test {

constexpr double pi = std::numbers::pi;

HeightMap map_of(const Grid& grid,
                 const std::function<double(double, double)>& height) {
  HeightMap map{grid, {}};
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      map.heights.push_back(
          height(ix * grid.spacing_x(), iy * grid.spacing_y()));
  return map;
}

// D cos(2 pi x/l): <|h|> = 2 D/pi up to the sum over 64 nodes, which is
// cot(pi/64)/32 instead of 2/pi; all others exact to roundoff.
TEST(HeightParameters, AreThoseOfACosine) {
  const HeightMap map = wave_1d({64, 8, 1e-5, 1e-5}, 2e-9, 1e-5);

  const HeightParameters found = height_parameters(map, true);

  EXPECT_NEAR(found.sa, 2e-9 / std::tan(pi / 64) / 32, 1e-22);
  EXPECT_NEAR(found.sq, 2e-9 / std::sqrt(2.0), 1e-22);
  EXPECT_NEAR(found.ssk, 0.0, 1e-13);
  EXPECT_NEAR(found.sku, 1.5, 1e-13);
  EXPECT_NEAR(found.sp, 2e-9, 1e-22);
  EXPECT_NEAR(found.sv, 2e-9, 1e-22);
  EXPECT_NEAR(found.sz, 4e-9, 1e-22);
  // A forward difference over h of a wave q is (2/h) sin(q h/2).
  const double spacing = 1e-5 / 64;
  const double slope = 2.0 / spacing * std::sin(pi / 64) * found.sq;
  EXPECT_NEAR(found.sdq / slope, 1.0, 1e-12);
  // To first order in slope^2 the excess area is half of it.
  EXPECT_NEAR(found.sdr / (0.5 * slope * slope), 1.0, 1e-4);
}

// A plane of slopes a and b has the area sqrt(1 + a^2 + b^2), whatever the
// shape of the cells. Tolerance: roundoff.
TEST(HeightParameters, MeasureTheAreaOfAPlane) {
  const Grid grid{5, 7, 5.0, 14.0};
  const HeightMap map =
      map_of(grid, [](double x, double y) { return 3.0 * x - 0.5 * y; });

  const HeightParameters found = height_parameters(map, false);

  EXPECT_NEAR(found.sdr, std::sqrt(1.0 + 9.0 + 0.25) - 1.0, 1e-12);
  EXPECT_NEAR(found.sdq, std::sqrt(9.25), 1e-12);
}

// h = x^2/2 + y^2: second differences 1 and 2 at any distance, Laplacian 3, and
// mean squares of the forward slopes x + d/2 and 2 y + d over the inside.
TEST(LocalDifferences, OfAParabolaAreExactInsideTheMap) {
  const Grid grid{6, 9, 6.0, 4.5};
  const HeightMap map =
      map_of(grid, [](double x, double y) { return 0.5 * x * x + y * y; });

  const LocalDifferences found = local_differences(map, 2, 1, false);

  EXPECT_EQ(found.distance_x, 2.0);
  EXPECT_EQ(found.distance_y, 0.5);
  EXPECT_NEAR(found.mean_square_second_x, 1.0, 1e-12);
  EXPECT_NEAR(found.mean_square_second_y, 4.0, 1e-11);
  EXPECT_NEAR(found.mean_square_laplacian, 9.0, 1e-11);
  EXPECT_NEAR(found.rms_curvature(), 1.5, 1e-12);
  // x = 0..3 plus 1: (1 + 4 + 9 + 16)/4
  EXPECT_NEAR(found.mean_square_slope_x, 7.5, 1e-12);
  EXPECT_EQ(found.lowest_second, 0.0);
}

// A periodic wave has the same differences whether or not its edges are used,
// if it is continued across them; q = pi/4 per node, lag 2.
TEST(LocalDifferences, ContinueAcrossPeriodicEdges) {
  const HeightMap map = wave_2d({16, 16, 1.0, 1.0}, 1e-3, 0.5);

  const LocalDifferences found = local_differences(map, 2, 2, true);

  const double q = 4.0 * pi;
  const double d = 2.0 / 16;
  const double second = std::pow(2.0 * std::sin(q * d / 2.0) / d, 2);
  EXPECT_NEAR(found.mean_square_second_x / (0.25e-6 * second * second), 1.0,
              1e-12);
  EXPECT_NEAR(found.mean_square_laplacian / (1e-6 * second * second), 1.0,
              1e-12);
  EXPECT_NEAR(found.lowest_second / (-1e-3 * second), 1.0, 1e-12);
  EXPECT_THROW(local_differences(map, 8, 2, false), std::domain_error);
  EXPECT_THROW(local_differences(map, 0, 2, true), std::domain_error);
}

// cos(qx) cos(qy): m_0 = D^2/4, m_2 = q^2 m_0, m_4 = q^4 m_0, alpha = 1 up to
// the finite differences of order (q h)^2/12 each; q h = 0.098.
TEST(LocalDifferences, GiveNayaksParameterOfAWave) {
  const HeightMap map = wave_2d({64, 64, 1.0, 1.0}, 1e-3, 1.0);

  const LocalDifferences found = local_differences(map, 1, 1, true);

  EXPECT_NEAR(nayak_parameter(0.25e-6, found), 1.0, 1e-9);
}

// A wave along x of 8 columns per period does not depend on y, so that its
// curvature and Nayak's parameter do not depend on the distance of the rows.
TEST(LocalDifferences, DoNotDependOnTheOtherSpacing) {
  const auto wave = [](double length_y) {
    const HeightMap map =
        map_of({16, 16, 16e-6, length_y},
               [](double x, double) { return std::cos(pi / 4e-6 * x); });
    return analyse_map(map, false, {});
  };
  const MapAnalysis square = wave(16e-6);

  for (const double length_y : {48e-6, 16e-3, 1e-6}) {
    const MapAnalysis found = wave(length_y);
    EXPECT_NEAR(found.neighbours.rms_curvature() /
                    square.neighbours.rms_curvature(),
                1.0, 1e-12);
    EXPECT_NEAR(found.nayak / square.nayak, 1.0, 1e-12);
    EXPECT_NEAR(found.heights.sdq / square.heights.sdq, 1.0, 1e-12);
  }
}

// The larger spacing exceeds a quarter of the shorter side: no distance is
// common to both directions, which is no reason to end.
TEST(ScaleDependence, IsEmptyWithoutACommonDistance) {
  const HeightMap map = map_of({4, 4, 5e-6, 10e-6}, [](double x, double y) {
    return std::sin(1e6 * x) + std::cos(3e6 * y);
  });

  EXPECT_TRUE(scale_dependence(map, false).empty());
  EXPECT_GT(analyse_map(map, false, {}).neighbours.rms_curvature(), 0.0);
  EXPECT_GT(analyse_map(map, true, 1e-8).nayak, 0.0);
}

TEST(ScaleDependence, CoversSpacingToAQuarterOfTheSide) {
  const HeightMap map = wave_2d({64, 128, 1.0, 1.0}, 1e-3, 1.0);

  const auto scales = scale_dependence(map, false);

  ASSERT_GT(scales.size(), 8U);
  EXPECT_EQ(scales.front().distance_x, 1.0 / 64);
  EXPECT_EQ(scales.front().distance_y, 1.0 / 64); // two of its own spacings
  EXPECT_LE(scales.back().distance(), 0.25);
  EXPECT_GT(scales.back().distance(), 0.2);
}

} // namespace asperity::surfaces::surface_parameters_test
