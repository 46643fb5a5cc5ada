// Tests of the condensed block with layers: it converges to the exact
// compliance of bonded layers (contact/operators/layered_compliance.hpp) at its
// order.
#include "contact/operators/layered_compliance.hpp"
#include "tests/fem/layer_solution.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::fem::layered_block_test {

using mechanics::FarBoundary;

/// A coating of thickness L/8, ten times stiffer than the substrate, which has
/// another Poisson's ratio and extends down to L/2.
constexpr double length = 1e-6;
constexpr double coating = length / 8;
constexpr double depth = length / 2;
constexpr double stiff = 2e10, stiff_nu = 0.2;
constexpr double soft = 2e9, soft_nu = 0.45;

mechanics::ElasticBlock exact_block(FarBoundary far_boundary) {
  return {soft / (1.0 - soft_nu * soft_nu),
          soft_nu,
          depth,
          far_boundary,
          {{coating, stiff, stiff_nu}}};
}

/// The same layers, divided into cells of this thickness.
LayeredBlock cells(double thickness, FarBoundary far_boundary) {
  LayeredBlock block;
  block.far_boundary = far_boundary;
  const auto add = [&](double of, double modulus, double nu) {
    for (long i = 0; i < std::lround(of / thickness); ++i)
      block.layers.push_back(elastic_layer(thickness, modulus, nu));
  };
  add(coating, stiff, stiff_nu);
  add(depth - coating, soft, soft_nu);
  return block;
}

class LayeredBlockOfElements : public ::testing::TestWithParam<FarBoundary> {
protected:
  /// Relative error of the compliance of the longest wave with cubic cells.
  static double error(int degree, int points) {
    const Grid grid{points, 4, length, 4 * length / points};
    return condensed_wave(degree, grid,
                          cells(degree * grid.spacing_x(), GetParam())) /
               exact() -
           1.0;
  }

  static double exact() {
    return contact::layered_compliance(wavevector(1, length),
                                       exact_block(GetParam()));
  }
};

// Verifies second-order convergence. Tolerances: the fourth-order term changes
// the ratio of errors from 4 by 0.019 here, measured; Richardson extrapolation
// then leaves 0.02/3 of the error on the fine grid, which is 7e-4.
TEST_P(LayeredBlockOfElements, OfFirstOrderConvergesAtSecond) {
  const double coarse = error(1, 64);
  const double fine = error(1, 128);

  EXPECT_NEAR(coarse / fine, 4.0, 0.03);
  EXPECT_NEAR((4.0 * fine - coarse) / 3.0, 0.0, 1e-5);
}

// Verifies fourth-order convergence in energy. Tolerances: the sixth-order term
// changes the ratio from 16 by 0.11, measured. The magnitude is a
// three-hundredth of Q1's.
TEST_P(LayeredBlockOfElements, OfSecondOrderConvergesAtFourth) {
  const double coarse = error(2, 64);
  const double fine = error(2, 128);

  EXPECT_NEAR(coarse / fine, 16.0, 0.2);
  EXPECT_LT(std::abs(fine), 3e-6);
}

INSTANTIATE_TEST_SUITE_P(Tops, LayeredBlockOfElements,
                         ::testing::Values(FarBoundary::clamped,
                                           FarBoundary::sliding,
                                           FarBoundary::pressure));

} // namespace asperity::fem::layered_block_test
