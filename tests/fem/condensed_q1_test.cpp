// Tests of fem/waves/condensed_q1.hpp. The references are deal.II's assembled
// block with a direct solver and the exact elastic layer.
#include "base/fourier.hpp"
#include "fem/block/full_block.hpp"
#include "fem/waves/condensed_q1.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/layer_solution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>

namespace asperity::fem::condensed_q1_test {

using mechanics::FarBoundary;

std::vector<double> apply(const Grid& grid,
                          const std::vector<double>& compliance,
                          const std::vector<double>& pressure) {
  const RealFourier fourier(grid);
  std::vector<std::complex<double>> spectrum(grid.half_spectrum_size());
  std::vector<double> displacement(grid.size());
  fourier.forward(pressure, spectrum);
  for (std::size_t i = 0; i < spectrum.size(); ++i)
    spectrum[i] *= compliance[i] / static_cast<double>(grid.size());
  fourier.backward(spectrum, displacement);
  return displacement;
}

class Q1AgainstTheFullBlock
    : public ::testing::TestWithParam<std::tuple<Grid, FarBoundary>> {};

// Verifies the condensed operator against the assembled block for every
// wavevector at once: a random pressure contains them all. Tolerance: roundoff
// of both solves, some 1e-13.
TEST_P(Q1AgainstTheFullBlock, GivesTheSameDisplacement) {
  const auto [grid, far_boundary] = GetParam();
  const LayeredBlock block =
      layered_block(1.5 * grid.spacing_x(), 0.8 * grid.length_x, far_boundary);
  const std::vector<double> pressure = random_field(grid.size(), 11);

  const std::vector<double> condensed =
      apply(grid, condensed_compliance_q1(grid, block), pressure);

  const std::vector<double> full =
      make_full_block(grid, 1, block, LinearSolver::direct)
          ->displacement(pressure);
  ASSERT_EQ(full.size(), grid.size());
  EXPECT_LT(largest_difference(condensed, full),
            1e-12 * largest_magnitude(full));
}

INSTANTIATE_TEST_SUITE_P(
    GridsAndTops, Q1AgainstTheFullBlock,
    ::testing::Combine(
        ::testing::Values(Grid{8, 8, 1e-6, 1e-6}, Grid{16, 16, 1e-6, 1e-6},
                          Grid{12, 6, 1e-6, 0.7e-6}, Grid{7, 9, 1e-6, 1e-6}),
        ::testing::Values(FarBoundary::clamped, FarBoundary::sliding,
                          FarBoundary::pressure)));

// The same on 32^2 nodes, the largest block whose direct solve takes only
// seconds.
INSTANTIATE_TEST_SUITE_P(AtThirtyTwo, Q1AgainstTheFullBlock,
                         ::testing::Values(std::tuple{Grid{32, 32, 1e-6, 1e-6},
                                                      FarBoundary::clamped}));

class Q1AgainstTheLayer : public ::testing::TestWithParam<FarBoundary> {};

// Verifies second-order convergence to the exact layer of finite depth, with
// cubic cells down to the far boundary: the longest wave of a block half as
// deep as it is long, where the three far boundaries differ by 20 %.
// Tolerances: the fourth-order term changes the ratio of errors from 4 by 12
// b/a h^2, measured as 0.19 between 32 and 64 points for the worst far
// boundary, hence 0.05 between 64 and 128; Richardson extrapolation then leaves
// 0.05/12 of the error on the fine grid, which is below 1e-3.
TEST_P(Q1AgainstTheLayer, ConvergesAtSecondOrder) {
  const double poisson_ratio = 0.35;
  const double length = 1.0e-6;
  const double exact =
      layer_compliance(wavevector(1, length), length / 2, soft_modulus,
                       poisson_ratio, GetParam());
  const auto error = [&](int points) {
    const Grid grid{points, 4, length, 4 * length / points};
    const std::vector<double> cubes(static_cast<std::size_t>(points / 2),
                                    length / points);
    const LayeredBlock block =
        homogeneous_block(cubes, soft_modulus, poisson_ratio, GetParam());
    return condensed_compliance_q1(grid, block)[1] / exact - 1.0;
  };

  const double coarse = error(64);
  const double fine = error(128);

  EXPECT_NEAR(coarse / fine, 4.0, 0.06);
  EXPECT_NEAR((4.0 * fine - coarse) / 3.0, 0.0, 4e-6);
}

INSTANTIATE_TEST_SUITE_P(Tops, Q1AgainstTheLayer,
                         ::testing::Values(FarBoundary::clamped,
                                           FarBoundary::sliding,
                                           FarBoundary::pressure));

// Verifies that the error of graded layers for long waves is of second order in
// the logarithm of the grading ratio, with the same wave and layers that grow
// by 1.2 and by its square root. Each depth is a sum of complete layers.
// Tolerance: the next order is (ln 1.2)^2 = 3 % of the ratio with a coefficient
// of order one, and counts three times.
TEST(Q1, LosesSecondOrderInTheGradingRatio) {
  const auto error = [](double growth) {
    const Grid grid{512, 4, 1e-5, 4 * 1e-5 / 512};
    std::vector<double> thickness{grid.spacing_x()};
    double depth = grid.spacing_x();
    while (depth < grid.length_x) {
      thickness.push_back(growth * thickness.back());
      depth += thickness.back();
    }
    const LayeredBlock block =
        homogeneous_block(thickness, soft_modulus, 0.3, FarBoundary::clamped);
    return condensed_compliance_q1(grid, block)[1] /
               layer_compliance(wavevector(1, grid.length_x), depth,
                                soft_modulus, 0.3, FarBoundary::clamped) -
           1.0;
  };

  EXPECT_NEAR(error(1.2) / error(std::sqrt(1.2)), 4.0, 0.36);
}

// Verifies that the symmetry of the square is detected: a grid that differs
// from the square only in the last bit of a length uses the general algorithm
// and gives the same values.
TEST(Q1, GivesTheSameValuesWithAndWithoutSymmetry) {
  const Grid square{16, 16, 1e-6, 1e-6};
  const Grid rectangle{16, 16, 1e-6, std::nextafter(1e-6, 1.0)};
  const LayeredBlock block =
      layered_block(1e-6 / 16, 1e-6, FarBoundary::clamped);

  const std::vector<double> mirrored = condensed_compliance_q1(square, block);
  const std::vector<double> plain = condensed_compliance_q1(rectangle, block);

  for (std::size_t i = 1; i < mirrored.size(); ++i)
    EXPECT_NEAR(mirrored[i] / plain[i], 1.0, 1e-12) << i;
}

TEST(Q1, DoesNotDependOnTheNumberOfThreads) {
  const Grid grid{32, 24, 1e-6, 1e-6};
  const LayeredBlock block =
      layered_block(1e-6 / 32, 1e-6, FarBoundary::sliding);

  EXPECT_EQ(condensed_compliance_q1(grid, block, 1),
            condensed_compliance_q1(grid, block, 3));
}

TEST(ElasticLayerOf, RefusesImpossibleModuli) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double poisson_ratio : {-1.0, 0.5, nan})
    EXPECT_THROW(elastic_layer(1e-6, soft_modulus, poisson_ratio),
                 std::domain_error)
        << poisson_ratio;
  for (const double wrong : {0.0, -1.0, nan}) {
    EXPECT_THROW(elastic_layer(wrong, soft_modulus, 0.3), std::domain_error);
    EXPECT_THROW(elastic_layer(1e-6, wrong, 0.3), std::domain_error);
  }
}

TEST(Q1, RefusesBadBlocksByName) {
  const Grid grid{8, 8, 1e-6, 1e-6};
  LayeredBlock block = layered_block(1e-6 / 8, 1e-6, FarBoundary::clamped);
  block.layers[1].shear_modulus = std::numeric_limits<double>::quiet_NaN();

  try {
    condensed_compliance_q1(grid, block);
    FAIL() << "a block without stiffness was accepted";
  } catch (const std::domain_error& error) {
    EXPECT_NE(std::string(error.what()).find("shear_modulus"),
              std::string::npos);
  }
  EXPECT_THROW(condensed_compliance_q1(grid, LayeredBlock{}),
               std::domain_error);
  block.layers[1].shear_modulus = 1.0;
  EXPECT_THROW(condensed_compliance_q1({1, 8, 1e-6, 1e-6}, block),
               std::domain_error);
}

} // namespace asperity::fem::condensed_q1_test
