// Tests of cases/reader/locking.hpp: above the Poisson's ratios at which it
// warns, elements are too stiff by more than the warning states, and below them
// by less.
#include "cases/reader/locking.hpp"
#include "contact/operators/layered_compliance.hpp"
#include "fem/waves/condensed_q1.hpp"
#include "fem/waves/condensed_q2.hpp"
#include "fem/waves/q2_operator.hpp"
#include "tests/fem/blocks.hpp"

#include <gtest/gtest.h>

#include <numbers>

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
  if (degree == 1)
    return condensed_compliance_q1(grid, block)[waves] / exact - 1.0;
  Q2Operator condensed(condensed_compliance_q2(grid, block));
  std::vector<double> wave(grid.size());
  for (std::size_t i = 0; i < wave.size(); ++i)
    wave[i] = std::cos(2.0 * std::numbers::pi * static_cast<double>(i) /
                       nodes_a_wave);
  std::vector<double> displacement(grid.size());
  condensed.displacement(wave, displacement);
  double work = 0.0, square = 0.0;
  for (std::size_t i = 0; i < wave.size(); ++i) {
    work += condensed.nodal_weights()[i] * wave[i] * displacement[i];
    square += condensed.nodal_weights()[i] * wave[i] * wave[i];
  }
  return work / square / exact - 1.0;
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
