// Tests of fem/waves/condensed_q2.hpp and fem/waves/q2_operator.hpp. The
// references are deal.II's assembled block with a direct solver and the exact
// elastic layer.
#include "fem/block/full_block.hpp"
#include "fem/waves/condensed_q2.hpp"
#include "fem/waves/q2_operator.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/layer_solution.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <tuple>

namespace asperity::fem::condensed_q2_test {

using mechanics::FarBoundary;

double weighted_product(std::span<const double> weights,
                        std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += weights[i] * a[i] * b[i];
  return sum;
}

std::vector<double> displacement(Q2Operator& block,
                                 const std::vector<double>& pressure) {
  std::vector<double> result(pressure.size());
  block.displacement(pressure, result);
  return result;
}

class Q2AgainstTheFullBlock
    : public ::testing::TestWithParam<std::tuple<Grid, FarBoundary>> {};

// Verifies the condensed operator against the assembled block for every
// wavevector and node class at once. 12 nodes are an even and 14 an odd number
// of cells; one of them has a middle column of modes that is conjugate to
// itself. Tolerance: roundoff of both solves, some 1e-13.
TEST_P(Q2AgainstTheFullBlock, GivesTheSameDisplacement) {
  const auto [grid, far_boundary] = GetParam();
  const LayeredBlock block =
      layered_block(2.0 * grid.spacing_x(), 0.8 * grid.length_x, far_boundary);
  const std::vector<double> pressure = random_field(grid.size(), 5);
  Q2Operator condensed(condensed_compliance_q2(grid, block));

  const std::vector<double> by_condensed = displacement(condensed, pressure);

  const auto full = make_full_block(grid, 2, block, LinearSolver::direct);
  const std::vector<double> by_full = full->displacement(pressure);
  ASSERT_EQ(by_full.size(), grid.size());
  EXPECT_LT(largest_difference(by_condensed, by_full),
            1e-12 * largest_magnitude(by_full));
  EXPECT_LT(
      largest_difference(condensed.nodal_weights(), full->nodal_weights()),
      1e-13);
}

INSTANTIATE_TEST_SUITE_P(
    GridsAndTops, Q2AgainstTheFullBlock,
    ::testing::Combine(::testing::Values(Grid{8, 8, 1e-6, 1e-6},
                                         Grid{12, 8, 1e-6, 0.7e-6},
                                         Grid{14, 6, 1e-6, 0.5e-6}),
                       ::testing::Values(FarBoundary::clamped,
                                         FarBoundary::sliding,
                                         FarBoundary::pressure)));

// Verifies independence of units: a compliance and its inverse in lengths and
// moduli that are larger by powers of two have the same bits, including an odd
// power of two in E L, whose square root is not a binary number.
TEST(Q2, HasTheSameBitsInBinaryUnits) {
  const Grid small{12, 12, 0.7e-6, 0.7e-6};
  const Grid large{12, 12, 0.7e-6 * 0x1p+20, 0.7e-6 * 0x1p+20};
  const auto block_on = [](const Grid& grid, double modulus) {
    const std::vector<double> layers{
        2.0 * grid.spacing_x(), 3.0 * grid.spacing_x(), 5.0 * grid.spacing_x()};
    return Q2Operator(condensed_compliance_q2(
        grid, homogeneous_block(layers, modulus, 0.4, FarBoundary::sliding)));
  };
  Q2Operator first = block_on(small, 3e9);
  Q2Operator second = block_on(large, 3e9 * 0x1p-17);
  const std::vector<double> pressure = random_field(small.size(), 3);

  const std::vector<double> by_first = displacement(first, pressure);
  const std::vector<double> by_second = displacement(second, pressure);
  std::vector<float> inverse_first(pressure.size());
  std::vector<float> inverse_second(pressure.size());
  first.pressure_estimate(std::vector<float>(by_first.begin(), by_first.end()),
                          1e-18, inverse_first);
  second.pressure_estimate(
      std::vector<float>(by_second.begin(), by_second.end()), 1e-18 * 0x1p+37,
      inverse_second);

  for (std::size_t i = 0; i < pressure.size(); ++i) {
    EXPECT_EQ(by_first[i] * 0x1p+37, by_second[i]);
    EXPECT_EQ(inverse_first[i], inverse_second[i]);
  }
}

// Verifies the conditions of the operator's interface: symmetry in the weighted
// product, zero weighted mean, and a preconditioner that inverts C + c except
// for the mean. Tolerances: roundoff of two transforms, and for the inverse
// single precision times its condition number, some 100.
TEST(Q2, SatisfiesTheConditionsOfAnOperator) {
  const Grid grid{20, 12, 1e-6, 1e-6};
  Q2Operator block(
      condensed_compliance_q2(grid, layered_block(2.0 * grid.spacing_x(), 1e-6,
                                                  FarBoundary::pressure)));
  const std::span<const double> weights = block.nodal_weights();
  const std::vector<double> first = random_field(grid.size(), 1);
  const std::vector<double> second = random_field(grid.size(), 2);
  const std::vector<double> ones(grid.size(), 1.0);

  const std::vector<double> by_first = displacement(block, first);
  const std::vector<double> by_second = displacement(block, second);

  const double energy = weighted_product(weights, first, by_first);
  EXPECT_GT(energy, 0.0);
  EXPECT_NEAR(weighted_product(weights, first, by_second) / energy,
              weighted_product(weights, second, by_first) / energy, 1e-13);
  EXPECT_NEAR(
      weighted_product(weights, ones, by_first) /
          (static_cast<double>(grid.size()) * largest_magnitude(by_first)),
      0.0, 1e-14);
  for (const double local : {0.0, 0.1 * block.short_wave_compliance()}) {
    std::vector<double> gap = by_first;
    for (std::size_t i = 0; i < gap.size(); ++i)
      gap[i] += local * first[i];
    std::vector<float> estimate(grid.size());
    block.pressure_estimate(std::vector<float>(gap.begin(), gap.end()), local,
                            estimate);
    for (std::size_t i = 0; i < gap.size(); ++i)
      EXPECT_NEAR(static_cast<double>(estimate[i]) - first[i],
                  static_cast<double>(estimate[0]) - first[0], 1e-5);
  }
}

// The patch test: a uniform pressure with consistent nodal areas gives a
// uniform displacement, which the gauge removes entirely. Tolerance: roundoff
// relative to the displacement of a random pressure of the same size.
TEST(Q2, PassesThePatchTest) {
  const Grid grid{16, 16, 1e-6, 1e-6};
  const Q2Compliance compliance = condensed_compliance_q2(
      grid, layered_block(2.0 * grid.spacing_x(), 1e-6, FarBoundary::clamped));
  std::array<double, 4> uniform{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      uniform[i] +=
          compliance.blocks[0][4 * i + j] * compliance.class_weights[j];

  for (std::size_t node_class = 1; node_class < 4; ++node_class)
    EXPECT_NEAR(uniform[node_class] / uniform[0], 1.0, 1e-13);
}

class Q2AgainstTheLayer
    : public ::testing::TestWithParam<std::tuple<FarBoundary, double>> {
protected:
  /// Relative error of the compliance of the longest wave, by virtual work,
  /// with cubic cells down to the far boundary of a block half as deep as it is
  /// long.
  static double error(int points) {
    const auto [far_boundary, poisson_ratio] = GetParam();
    const Grid grid{points, 4, 1e-6, 4e-6 / points};
    const std::vector<double> cubes(static_cast<std::size_t>(points / 4),
                                    2.0 * grid.spacing_x());
    return condensed_wave(2, grid,
                          homogeneous_block(cubes, soft_modulus, poisson_ratio,
                                            far_boundary)) /
               layer_compliance(wavevector(1, grid.length_x), grid.length_x / 2,
                                soft_modulus, poisson_ratio, far_boundary) -
           1.0;
  }
};

// Verifies fourth-order convergence in energy, near incompressibility too: no
// locking. Tolerances: the sixth-order term changes the ratio of errors from 16
// by up to 1.8, measured between 32 and 64 nodes per wavelength, hence by a
// fourth of that here. The magnitude: 1e-5 (2e-4 at nu = 0.49), about the error
// of Q1 with four times as many nodes in each direction.
TEST_P(Q2AgainstTheLayer, ConvergesAtFourthOrderWithoutLocking) {
  const double poisson_ratio = std::get<1>(GetParam());

  const double coarse = error(64);
  const double fine = error(128);

  EXPECT_NEAR(coarse / fine, 16.0, 0.8);
  EXPECT_LT(std::abs(coarse), poisson_ratio < 0.4 ? 1e-5 : 2e-4);
}

INSTANTIATE_TEST_SUITE_P(
    TopsAndPoissonRatios, Q2AgainstTheLayer,
    ::testing::Combine(::testing::Values(FarBoundary::clamped,
                                         FarBoundary::sliding,
                                         FarBoundary::pressure),
                       ::testing::Values(0.0, 0.3, 0.49)));

TEST(Q2, RefusesAGridOfHalfCells) {
  const LayeredBlock block =
      layered_block(1e-6 / 4, 1e-6, FarBoundary::clamped);

  EXPECT_THROW(condensed_compliance_q2({9, 8, 1e-6, 1e-6}, block),
               std::domain_error);
}

} // namespace asperity::fem::condensed_q2_test
