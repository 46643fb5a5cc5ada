// Tests of second-order blocks under a coating ten times stiffer, in hard
// contact. A force at one node may increase the gap at another there, so that
// the active set cycles if the contact forces are not known well.
#include "contact/solvers/solver.hpp"
#include "fem/block/full_block.hpp"
#include "fem/waves/condensed_q2.hpp"
#include "fem/waves/q2_operator.hpp"
#include "tests/fem/blocks.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace asperity::fem::coated_block_test {

using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::FarBoundary;

const Grid grid{32, 32, 1e-5, 1e-5};
constexpr double coating_modulus = 10.0 * soft_modulus;
constexpr double coating = 0.05 * 1e-5; // m
constexpr double contact_modulus = soft_modulus / (1.0 - 0.4 * 0.4);

/// Waves down to 8 spacings with random phases, rms slope 0.1.
std::vector<double> rough_heights(unsigned int seed) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> phase(0.0, 2.0 * std::numbers::pi);
  std::vector<double> heights(grid.size(), 0.0);
  double square_of_slope = 0.0;
  for (int kx = 0; kx <= 4; ++kx)
    for (int ky = -4; ky <= 4; ++ky) {
      const int square = kx * kx + ky * ky;
      if (square == 0 || square > 16 || (kx == 0 && ky < 0))
        continue;
      const double shift = phase(engine);
      const double unit = 2.0 * std::numbers::pi / grid.points_x;
      for (int iy = 0; iy < grid.points_y; ++iy)
        for (int ix = 0; ix < grid.points_x; ++ix)
          heights[grid.index(ix, iy)] +=
              std::cos(unit * (kx * ix + ky * iy) + shift);
      square_of_slope += 0.5 * square * std::pow(unit / grid.spacing_x(), 2);
    }
  for (double& height : heights)
    height *= 0.1 / std::sqrt(square_of_slope);
  return heights;
}

LayeredBlock coated_block() {
  return bonded_block(
      meshes::graded_layers_with_interfaces(2.0 * grid.spacing_x(), 1.2,
                                            std::vector{coating}, 1e-5),
      std::vector{coating},
      std::vector<mechanics::BodyModuli>{{coating_modulus, 0.2},
                                         {soft_modulus, 0.4}},
      FarBoundary::clamped);
}

double rms(const std::vector<double>& heights) {
  double square = 0.0;
  for (const double height : heights)
    square += height * height;
  return std::sqrt(square / static_cast<double>(heights.size()));
}

// Verifies that hard contact is solved to the tolerance of the case at every
// load, and that the solution is that of the condensed block, which another
// solver finds. Tolerances: both gaps are exact to 1e-8 h_rms, which with the
// stiffness of the coating is a ten-millionth of the largest pressure; a
// hundred times as much is allowed. If all linear systems are solved to the
// usual 1e-2, the active set of the second step cycles, and the note says that
// the augmented-Lagrangian method has solved it.
TEST(CoatedBlock, IsSolvedInHardContactByTheActiveSet) {
  const LayeredBlock block = coated_block();
  const std::vector<double> heights = rough_heights(1);
  const double scale = rms(heights);
  Q2Operator condensed(condensed_compliance_q2(grid, block));
  const auto full = make_full_block(grid, 2, block, LinearSolver::multigrid);
  const double spring = 100.0 * contact_modulus / grid.spacing_x();
  for (const double load : {0.02, 0.05, 0.08}) {
    const double pressure = load * contact_modulus;
    const contact::ContactSolution expected = contact::solve_contact(
        condensed, {heights, 0.0, 1e-8 * scale, 2000},
        {mechanics::Control::nominal_pressure, pressure});

    const BlockSolution found =
        full->solve(heights, {Control::nominal_pressure, pressure},
                    {ContactLaw::hard, spring, 1e-8, 200});

    ASSERT_TRUE(expected.converged) << expected.note;
    ASSERT_TRUE(found.converged) << found.note;
    EXPECT_EQ(found.note, "") << load;
    EXPECT_NEAR(found.nominal_pressure / pressure, 1.0, 1e-8);
    for (std::size_t i = 0; i < grid.size(); ++i) {
      EXPECT_GE(found.pressure[i], 0.0);
      EXPECT_GE(found.gap[i], -1e-8 * scale);
      if (found.pressure[i] > 0.0) {
        EXPECT_LE(found.gap[i], 1e-8 * scale);
      }
    }
    EXPECT_NEAR(found.mean_gap, expected.mean_gap, 1e-6 * scale);
    EXPECT_LT(largest_difference(found.gap, expected.gap), 1e-6 * scale);
    EXPECT_LT(largest_difference(found.pressure, expected.pressure),
              1e-5 * largest_magnitude(expected.pressure));
  }
}

} // namespace asperity::fem::coated_block_test
