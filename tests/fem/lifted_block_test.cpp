// Tests of the full block without contact after contact (full_block.hpp). The
// reference is the undeformed surface.
#include "fem/block/full_block.hpp"
#include "tests/fem/blocks.hpp"

#include <gtest/gtest.h>

namespace asperity::fem::lifted_block_test {

using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::FarBoundary;

class LiftedOff : public ::testing::TestWithParam<ContactLaw> {};

// A block that was pressed and is lifted off has no displacement, and its gap
// is that of the undeformed surface, to roundoff: no contact force remains,
// against which an imbalance is measured.
TEST_P(LiftedOff, LeavesNoDisplacementOfTheLoadBefore) {
  const Grid grid{8, 8, 1e-6, 1e-6};
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

} // namespace asperity::fem::lifted_block_test
