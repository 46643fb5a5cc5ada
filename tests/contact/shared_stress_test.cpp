// Tests of the stress inside a block whose surface rows several ranks share: it
// has the bits of one process. Tolerance: none.
#include "contact/operators/stress_inside.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace asperity::contact::shared_stress_test {

constexpr double infinity = std::numeric_limits<double>::infinity();
const mechanics::ElasticBlock half_space{2.0, 0.3, infinity};

/// A pressure without symmetries.
std::vector<double> uneven_pressure(const Grid& grid) {
  std::vector<double> pressure;
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      pressure.push_back(std::max(0.0, std::sin(0.3 * ix + 0.2 * iy) *
                                           std::cos(0.011 * ix * iy)));
  return pressure;
}

std::vector<int> bounds_of(const Grid& grid, int n) {
  std::vector<int> bounds{0};
  for (int r = 1; r < n; ++r)
    bounds.push_back(2 * r * r);
  bounds.push_back(grid.points_y);
  return bounds;
}

void expect_bits_of_one_process(const Grid& grid,
                                const mechanics::ElasticBlock& block) {
  const std::vector<double> pressure = uneven_pressure(grid);
  const StressInside whole(grid, block, pressure);
  const StressPeak peak = whole.strongest();
  const double shear = whole.shear_at(peak);
  const StressPlane plane = whole.at_depth(0.1);
  const std::vector<double> row = whole.von_mises_row(0.1, 7);
  ASSERT_EQ(row.size(), static_cast<std::size_t>(grid.points_x));
  EXPECT_EQ(largest_shear(whole.at_depth(peak.depth, peak.side))[peak.node],
            shear);
  for (int n = 1; n <= 4; ++n)
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      const SharedRows rows(grid, ranks, bounds_of(grid, n));
      const auto own_of = [&](const std::vector<double>& map) {
        return std::span(map).subspan(grid.index(0, rows.first()), rows.size());
      };
      const StressInside shared(rows, block, own_of(pressure), n == 2 ? 2 : 1);
      const StressPeak found = shared.strongest();
      EXPECT_EQ(found.von_mises, peak.von_mises);
      EXPECT_EQ(found.depth, peak.depth);
      EXPECT_EQ(found.node, peak.node);
      EXPECT_EQ(found.side, peak.side);
      EXPECT_EQ(shared.shear_at(found), shear);
      EXPECT_EQ(shared.von_mises_row(0.1, 7), row);
      const StressPlane own = shared.at_depth(0.1);
      EXPECT_TRUE(std::ranges::equal(own.xy, own_of(plane.xy)));
      EXPECT_TRUE(std::ranges::equal(own.yz, own_of(plane.yz)));
    });
}

TEST(SharedStress, OfAHalfSpaceHasTheBitsOfOneProcess) {
  expect_bits_of_one_process({48, 40, 1.0, 0.8}, half_space);
  expect_bits_of_one_process({45, 41, 1.0, 0.8}, half_space);
}

TEST(SharedStress, OfLayersHasTheBitsOfOneProcess) {
  mechanics::ElasticBlock block{2.0, 0.3, 0.5};
  block.layers.push_back({0.06, 3.0, 0.2});
  expect_bits_of_one_process({48, 40, 1.0, 0.8}, block);
}

// The first of the nodes with the largest stress, whichever rank has it.
TEST(SharedStress, OfAPeriodicPressureIsFoundAtTheFirstNode) {
  const Grid grid{16, 16, 1.0, 1.0};
  std::vector<double> pressure(grid.size(), 0.0);
  for (const int iy : {3, 11})
    pressure[grid.index(5, iy)] = 1.0;
  const std::size_t node =
      StressInside(grid, half_space, pressure).strongest().node;
  tests::on_thread_ranks(2, [&](RankGroup& ranks) {
    const SharedRows rows(grid, ranks, {0, 8, 16});
    const StressInside shared(
        rows, half_space,
        std::span(pressure).subspan(grid.index(0, rows.first()), rows.size()),
        1);
    EXPECT_EQ(shared.strongest().node, node);
  });
}

} // namespace asperity::contact::shared_stress_test
