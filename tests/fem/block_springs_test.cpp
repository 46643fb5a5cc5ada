// Tests of fem/block/full_block.hpp with very soft and very stiff penalties:
// the springs that the block uses stay in the range of Newton's method, and the
// solution is that of the given penalty. The reference is the condensed block
// with the solver of the module contact, to which a penalty is a compliance of
// any size.
#include "contact/operators/fourier_operator.hpp"
#include "contact/solvers/solver.hpp"
#include "fem/block/full_block.hpp"
#include "fem/waves/condensed_q1.hpp"
#include "tests/fem/blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace asperity::fem::block_springs_test {

using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::FarBoundary;

constexpr Grid grid{8, 8, 1e-6, 1e-6};

LayeredBlock small_block() {
  return layered_block(grid.spacing_x(), 0.5e-6, FarBoundary::sliding);
}

struct Spring {
  ContactLaw law;
  double penalty; ///< in E/h
};

class AnyPenalty : public ::testing::TestWithParam<Spring> {};

// Tolerance: the full model converges to 1e-9 of the rms height, which is some
// 6 nm, and the reference to 1e-10 of it.
TEST_P(AnyPenalty, GivesTheAnswerOfTheCondensedBlock) {
  const double penalty = GetParam().penalty * soft_modulus / grid.spacing_x();
  const bool is_penalty = GetParam().law == ContactLaw::penalty;
  const double load = 2e6;
  std::vector<double> heights = random_field(grid.size(), 4);
  for (double& height : heights)
    height *= 1e-8;
  contact::FourierOperator elasticity(
      grid, condensed_compliance_q1(grid, small_block()));
  const contact::ContactSolution expected = contact::solve_contact(
      elasticity, {heights, is_penalty ? 1.0 / penalty : 0.0, 1e-18, 2000},
      {mechanics::Control::nominal_pressure, load});

  const BlockSolution found =
      make_full_block(grid, 1, small_block())
          ->solve(heights, {Control::nominal_pressure, load},
                  {GetParam().law, penalty, 1e-9, 200});

  ASSERT_TRUE(expected.converged) << expected.note;
  ASSERT_TRUE(found.converged) << found.note;
  EXPECT_NEAR(found.mean_gap, expected.mean_gap, 1e-17);
  EXPECT_LT(largest_difference(found.pressure, expected.pressure),
            1e-8 * largest_magnitude(expected.pressure));
}

INSTANTIATE_TEST_SUITE_P(Extremes, AnyPenalty,
                         ::testing::Values(Spring{ContactLaw::penalty, 1e5},
                                           Spring{ContactLaw::penalty, 1e7},
                                           Spring{ContactLaw::penalty, 1e15},
                                           Spring{ContactLaw::augmented, 1e-6},
                                           Spring{ContactLaw::augmented, 1e15},
                                           Spring{ContactLaw::hard, 1e15}));

// A load so small that it moves the surface by less than the roundoff of the
// heights must be balanced too: the upper half of a stepped surface carries it.
// The lower half touches nothing.
TEST(SmallLoad, IsCarriedByAPlateau) {
  std::vector<double> heights(grid.size(), -0.7e-6);
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x / 2; ++ix)
      heights[grid.index(ix, iy)] = 0.3e-6;
  const double load = 1e-11 * soft_modulus;

  const BlockSolution found =
      make_full_block(grid, 1, small_block())
          ->solve(heights, {Control::nominal_pressure, load},
                  {ContactLaw::augmented,
                   50.0 * soft_modulus / grid.spacing_x(), 1e-8, 200});

  ASSERT_TRUE(found.converged) << found.note << ", " << found.residual;
  EXPECT_NEAR(found.nominal_pressure / load, 1.0, 1e-8);
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = grid.points_x / 2; ix < grid.points_x; ++ix)
      EXPECT_EQ(found.pressure[grid.index(ix, iy)], 0.0);
}

// A flat surface has a tolerance in terms of its own lengths: with augmentation
// it carries its load uniformly at the scale of a metre and of a picometre.
TEST(FlatSurface, DoesNotDependOnUnits) {
  for (const double length : {1.0, 1e-12}) {
    const Grid flat{8, 8, length, length};
    const auto full = make_full_block(
        flat, 1, layered_block(flat.spacing_x(), length, FarBoundary::clamped));

    const BlockSolution found = full->solve(
        std::vector<double>(flat.size(), 0.0),
        {Control::nominal_pressure, 1e-3 * soft_modulus},
        {ContactLaw::augmented, soft_modulus / flat.spacing_x(), 1e-9, 100});

    ASSERT_TRUE(found.converged) << length << ": " << found.note;
    EXPECT_LT(std::abs(found.mean_gap), 1e-9 * flat.spacing_x());
  }
}

} // namespace asperity::fem::block_springs_test
