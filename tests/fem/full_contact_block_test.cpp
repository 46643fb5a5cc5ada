// Tests of the full block in full contact under a stiff penalty and a
// prescribed mean gap (full_block.hpp). The reference is the contact law: if
// all points are in contact, the mean gap is minus the nominal pressure over
// the penalty.
#include "fem/block/full_block.hpp"
#include "tests/fem/blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace asperity::fem::full_contact_block_test {

using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::FarBoundary;

constexpr double penalty = 1e25;    // Pa/m, 1e9 shear moduli per spacing
constexpr double tolerance = 1e-8;  // of a gap, relative to h_rms
constexpr double roughness = 1e-10; // range of the heights [m]

struct FullContact {
  Grid grid{8, 8, 1e-6, 1e-6};
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
                        {ContactLaw::penalty, penalty, tolerance, 2000});
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
    EXPECT_NEAR(found.nominal_pressure, -penalty * mean_gap,
                penalty * tolerance * roughness);
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

} // namespace asperity::fem::full_contact_block_test
