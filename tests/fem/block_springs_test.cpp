// Claims about fem/block/full_block.hpp at the ends of what a penalty can be:
// its own springs stay within reach of Newton's method, and the answer is the
// one that was asked for. The judge is the condensed block under the contact
// module's solver, to which a penalty is a compliance and any stiffness is
// alike.
#include "contact/operators/fourier_operator.hpp"
#include "contact/solvers/solver.hpp"
#include "fem/block/full_block.hpp"
#include "fem/waves/condensed_q1.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/fem/blocks.hpp"

namespace asperity::fem {
namespace {

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

class AnySpring : public ::testing::TestWithParam<Spring> {};

// Tolerance: the block ends at 1e-9 of the rms height, some 6 nm, and the judge
// at 1e-10 of it.
TEST_P(AnySpring, GivesTheAnswerOfTheCondensedBlock) {
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

INSTANTIATE_TEST_SUITE_P(Extremes, AnySpring,
                         ::testing::Values(Spring{ContactLaw::penalty, 1e5},
                                           Spring{ContactLaw::penalty, 1e7},
                                           Spring{ContactLaw::penalty, 1e15},
                                           Spring{ContactLaw::augmented, 1e-6},
                                           Spring{ContactLaw::augmented, 1e15},
                                           Spring{ContactLaw::hard, 1e15}));

// Claim: a load so small that it moves the face by less than the heights'
// rounding is balanced too: the plateau of a step bears it. The other half is a
// step below and touches nothing.
TEST(SmallLoad, IsBornByAPlateau) {
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

// Claim: a flat surface has a tolerance of its own, in its own lengths: by
// augmentation it bears its load evenly at a metre and at a picometre.
TEST(FlatSurface, HasNoUnitOfItsOwn) {
  for (const double length : {1.0, 1e-12}) {
    const Grid flat{8, 8, length, length};
    const auto whole = make_full_block(
        flat, 1, layered_block(flat.spacing_x(), length, FarBoundary::clamped));

    const BlockSolution found = whole->solve(
        std::vector<double>(flat.size(), 0.0),
        {Control::nominal_pressure, 1e-3 * soft_modulus},
        {ContactLaw::augmented, soft_modulus / flat.spacing_x(), 1e-9, 100});

    ASSERT_TRUE(found.converged) << length << ": " << found.note;
    EXPECT_LT(std::abs(found.mean_gap), 1e-9 * flat.spacing_x());
  }
}

} // namespace
} // namespace asperity::fem
