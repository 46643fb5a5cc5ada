// Tests of fem/block/full_block.hpp with very soft and very stiff penalties, in
// full contact and without contact after contact: the springs that the block
// uses stay in the range of Newton's method, and the solution is that of the
// given penalty. The reference is the condensed block with the solver of the
// module contact, to which a penalty is a compliance of any size.
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

// In full contact the mean gap is minus the nominal pressure over the penalty.
constexpr double stiff_penalty = 1e25; // Pa/m, 1e9 shear moduli per spacing
constexpr double tolerance = 1e-8;     // of a gap, relative to h_rms
constexpr double roughness = 1e-10;    // range of the heights [m]

struct FullContact {
  std::unique_ptr<FullBlock> block;
  std::vector<double> heights;

  explicit FullContact(int degree)
      : block(make_full_block(grid, degree,
                              layered_block(degree * grid.spacing_x(), 1e-6,
                                            FarBoundary::sliding))),
        heights(random_field(grid.size(), 3)) {
    for (double& height : heights)
      height *= roughness;
  }

  BlockSolution solved(double mean_gap) {
    return block->solve(heights, {Control::mean_gap, mean_gap},
                        {ContactLaw::penalty, stiff_penalty, tolerance, 2000});
  }
};

// The working penalty is 1e4 times softer, so that augmentation alone would
// take 1e4 steps. A gap is known to the tolerance, 1e-8 of at most the range of
// the heights, and the pressure to the penalty times that.
TEST(FullContactUnderAStiffPenalty, HasThePressureOfThePrescribedMeanGap) {
  for (const int degree : {1, 2}) {
    const double mean_gap = -1e-15;

    const BlockSolution found = FullContact(degree).solved(mean_gap);

    ASSERT_TRUE(found.converged) << found.note;
    EXPECT_NEAR(found.nominal_pressure, -stiff_penalty * mean_gap,
                stiff_penalty * tolerance * roughness);
    EXPECT_NEAR(found.mean_gap, mean_gap, tolerance * roughness);
    EXPECT_LT(found.iterations, 30) << degree;
  }
}

// A pressure under which the block is compressed so far that the gaps, which
// are differences of displacements, cannot be represented to the tolerance.
TEST(FullContactUnderAStiffPenalty, SaysThatGapsCannotBeRepresented) {
  const BlockSolution found = FullContact(2).solved(-1e-10);

  EXPECT_FALSE(found.converged);
  EXPECT_LT(found.iterations, 30);
  EXPECT_NE(found.note.find("requires a nominal pressure of 1e+15 Pa"),
            std::string::npos)
      << found.note;
  EXPECT_NE(found.note.find("must be at most the tolerance"), std::string::npos)
      << found.note;
}

class LiftedOff : public ::testing::TestWithParam<ContactLaw> {};

// A block that was pressed and is lifted off has no displacement, and its gap
// is that of the undeformed surface, to roundoff: no contact force remains,
// against which an imbalance is measured.
TEST_P(LiftedOff, LeavesNoDisplacementOfTheLoadBefore) {
  for (const int degree : {1, 2}) {
    const auto full = make_full_block(
        grid, degree,
        layered_block(degree * grid.spacing_x(), 1e-6, FarBoundary::sliding));
    std::vector<double> heights = random_field(grid.size(), 3);
    for (double& height : heights)
      height *= 1e-9;
    const BlockContact contact{GetParam(), 1e17, 1e-8, 200};
    const BlockSolution pressed =
        full->solve(heights, {Control::mean_gap, 0.0}, contact);
    ASSERT_TRUE(pressed.converged) << pressed.note;
    ASSERT_GT(pressed.nominal_pressure, 0.0);

    const BlockSolution found =
        full->solve(heights, {Control::mean_gap, 1e-7}, contact);

    ASSERT_TRUE(found.converged) << found.note;
    EXPECT_EQ(found.nominal_pressure, 0.0);
    EXPECT_LT(found.residual, 1e-12);
    double mean = 0.0;
    for (std::size_t i = 0; i < heights.size(); ++i)
      mean += full->nodal_weights()[i] * heights[i] /
              static_cast<double>(heights.size());
    std::vector<double> undeformed(heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i)
      undeformed[i] = 1e-7 - (heights[i] - mean);
    EXPECT_LT(largest_difference(found.gap, undeformed), 1e-21) << degree;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, LiftedOff,
                         ::testing::Values(ContactLaw::penalty,
                                           ContactLaw::hard,
                                           ContactLaw::augmented));

} // namespace asperity::fem::block_springs_test
