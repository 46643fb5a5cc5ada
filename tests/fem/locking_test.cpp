// Tests of input/reader/locking.hpp: above the Poisson's ratios at which it
// warns, elements are too stiff by more than the warning states, and below them
// by less.
#include "contact/operators/layered_compliance.hpp"
#include "input/reader/locking.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/layer_solution.hpp"

#include <gtest/gtest.h>

namespace asperity::fem::locking_test {

const Grid grid{32, 32, 1e-5, 1e-5};
constexpr int nodes_a_wave = 8;

/// The compliance of a wave of eight nodes relative to the exact one of the
/// same block, minus 1.
double error(int degree, double poisson_ratio) {
  LayeredBlock block;
  for (const double thickness :
       meshes::graded_layers(degree * grid.spacing_x(), 1.2, grid.length_x))
    block.layers.push_back(
        elastic_layer(thickness, soft_modulus, poisson_ratio));
  constexpr int waves = 32 / nodes_a_wave;
  const double exact = contact::layered_compliance(
      wavevector(waves, grid.length_x),
      {soft_modulus / (1.0 - poisson_ratio * poisson_ratio), poisson_ratio,
       grid.length_x, mechanics::FarBoundary::clamped});
  return condensed_wave(degree, grid, block, waves) / exact - 1.0;
}

// Verifies that at the ratios of the warning a wave of eight nodes is more than
// a tenth too stiff with Q1 and more than a twentieth with Q2, and less at
// ratios that are 0.005 smaller.
TEST(Locking, IsWarnedOfWhereElementsAreTooStiff) {
  const double q1 = cases::locking_ratio(mechanics::Element::q1);
  const double q2 = cases::locking_ratio(mechanics::Element::q2);

  EXPECT_LT(error(1, q1), -0.1);
  EXPECT_GT(error(1, q1 - 0.005), -0.1);
  EXPECT_LT(error(2, q2), -0.05);
  EXPECT_GT(error(2, q2 - 0.005), -0.05);
}

} // namespace asperity::fem::locking_test
