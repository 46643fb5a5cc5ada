// Tests of the mean gap of blocks whose mesh follows the contact: it can be
// prescribed, and it is that of all heights.
#include "surfaces/maps/exact_shapes.hpp"
#include "tests/fem/adaptive_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace asperity::fem::adaptive_gaps_test {

// The mean gap that is found under a load is the load that is found
// under this mean gap, to 1e-5.
TEST(AdaptiveGaps, ControlsTheMeanGap) {
  const Grid grid{32, 32, length, length};
  const std::vector<double> heights = self_affine_heights(grid);
  const auto block = adapted_block(adaptive_problem(grid, 2, 2));
  const BlockSolution by_load =
      block->solve(heights, pressed(0.001), contact_of(grid));

  const BlockSolution by_gap = block->solve(
      heights, {Control::mean_gap, by_load.mean_gap}, contact_of(grid));

  ASSERT_TRUE(by_gap.converged) << by_gap.note;
  EXPECT_LT(share(by_gap.nominal_pressure, by_load.nominal_pressure), 1e-5);
  EXPECT_LT(share(by_gap.mean_gap, by_load.mean_gap), 1e-8);
}

// The mean gap, prescribed or found, is that of the grid, although the
// nodes of the coarsest cells see only the crests of a wave on the sphere. Of
// its amplitude, samples of the displacement may cost a hundredth.
TEST(AdaptiveGaps, AveragesAllHeights) {
  const Grid grid{64, 64, length, length};
  constexpr double amplitude = 5e-4 * length;
  const std::vector<double> wave = wave_heights(grid, amplitude, 8);
  std::vector<double> heights =
      surfaces::paraboloid(grid, 10.0 * length).heights;
  for (std::size_t i = 0; i < heights.size(); ++i)
    heights[i] += wave[i];
  const auto block = make_adaptive_block(adaptive_problem(grid, 2, 3));
  const BlockSolution by_load =
      block->solve(heights, pressed(1e-4), contact_of(grid));
  const BlockSolution by_gap = block->solve(
      heights, {Control::mean_gap, 1.01 * by_load.mean_gap}, contact_of(grid));

  ASSERT_TRUE(by_load.converged && by_gap.converged) << by_gap.note;
  EXPECT_LT(share(by_gap.mean_gap, 1.01 * by_load.mean_gap), 1e-8);
  for (const BlockSolution& found : {by_load, by_gap}) {
    double mean = 0.0;
    for (const double gap : found.gap)
      mean += gap / static_cast<double>(grid.size());
    EXPECT_NEAR(mean, found.mean_gap, 0.01 * amplitude);
  }
}

// A cup almost in full contact at a mean gap of a hundredth of its height. The
// mean height of the first-order nodes of the coarsest mesh is too large by
// 0.078 of it, so that no load leads to this mean gap there. The mesh refines
// until the load is that of the uniform block, whose nodes are those of the
// finest cells.
TEST(AdaptiveGaps, ReachesSmallMeanGaps) {
  const Grid grid{16, 16, length, length};
  constexpr double height = 1e-3 * length;
  std::vector<double> heights =
      surfaces::paraboloid(grid, 0.125 * length * length / height).heights;
  for (double& value : heights)
    value = -value;
  for (const int degree : {1, 2}) {
    const auto block =
        make_adaptive_block(adaptive_problem(grid, degree, 3 - degree));
    const auto uniform = uniform_block(grid, degree);
    const mechanics::LoadTarget light{Control::mean_gap, height};
    const mechanics::LoadTarget target{Control::mean_gap, 0.01 * height};
    ASSERT_TRUE(block->solve(heights, light, contact_of(grid)).converged);

    const BlockSolution found = block->solve(heights, target, contact_of(grid));
    const BlockSolution expected =
        uniform->solve(heights, target, contact_of(grid));

    ASSERT_TRUE(found.converged && expected.converged) << found.note;
    EXPECT_LT(share(found.mean_gap, target.amount), 1e-6);
    EXPECT_LT(share(found.nominal_pressure, expected.nominal_pressure), 0.05)
        << degree;
  }
}

} // namespace asperity::fem::adaptive_gaps_test
