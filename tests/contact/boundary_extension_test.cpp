// Tests of contact/solvers/boundary_extension.hpp.
#include "contact/solvers/boundary_extension.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace asperity::contact::boundary_extension_test {

constexpr double share = 0.9;

std::vector<std::uint8_t> patches(const Grid& grid) {
  std::vector<std::uint8_t> is_free(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      is_free[grid.index(ix, iy)] =
          std::sin(0.2 * ix) + std::cos(0.3 * iy) > 0.8 ? 2 : 0;
  return is_free;
}

BlockFlags blocks_with(const std::vector<std::uint8_t>& is_free) {
  BlockFlags flags(blocks_of(is_free.size()));
  for (std::size_t i = 0; i < is_free.size(); ++i)
    if (is_free[i] > 0)
      flags[i / block_nodes] = 1;
  return flags;
}

std::vector<float> random_field(std::size_t size, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> value(-1.0F, 1.0F);
  std::vector<float> field(size);
  for (float& entry : field)
    entry = value(random);
  return field;
}

std::vector<float>
extended(const Grid& grid, double own_share,
         const std::vector<std::uint8_t>& is_free,
         const std::vector<float>& residual,
         Continuation continuation = Continuation::periodic) {
  BoundaryExtension extension(grid, 1, continuation);
  extension.build(own_share, is_free);
  std::vector<float> field(grid.size(), 7.0F);
  extension.extend({is_free, blocks_with(is_free)}, residual, field);
  std::vector<float> in_place = residual;
  extension.extend({is_free, blocks_with(is_free)}, in_place, in_place);
  EXPECT_EQ(in_place, field);
  return field;
}

// One active node in each 2 by 2 cell of a 16^2 grid has 3. All cells of a
// level are then alike, and (R.1) is by hand, for levels of 8^2 and 4^2 cells
// with the variances 1/2 and, on the coarsest level, 4/4: n_1 = s, n_2 = 4 k_1
// n_1, and e_l = 3 (1 - k_l) + k_l e_(l+1).
TEST(BoundaryExtension, ContinuesAUniformResidualAsComputedByHand) {
  const Grid grid{16, 16, 1.0, 1.0};
  std::vector<std::uint8_t> is_free(grid.size());
  std::vector<float> residual(grid.size());
  for (int iy = 0; iy < grid.points_y; iy += 2)
    for (int ix = 0; ix < grid.points_x; ix += 2) {
      is_free[grid.index(ix, iy)] = 2;
      residual[grid.index(ix, iy)] = 3.0F;
    }
  for (const double own_share : {1.0, share, 0.01}) {
    const double k_1 = 1.0 / (1.0 + 0.5 * own_share);
    const double k_2 = 1.0 / (1.0 + 4.0 * k_1 * own_share);
    const double outside = 3.0 * (1.0 - k_1 * k_2);

    const std::vector<float> field =
        extended(grid, own_share, is_free, residual);

    for (std::size_t i = 0; i < grid.size(); ++i)
      EXPECT_NEAR(static_cast<double>(field[i]), is_free[i] > 0 ? 3.0 : outside,
                  1e-5);
  }
}

// Around one active node on the edge of the grid the field wraps around and
// falls off. The correlation of a random field with the spectrum 1/q is
// proportional to 1/distance, so that it is divided by 4 where the distance is
// multiplied by 4. The factor of 2 is for cells instead of distances.
TEST(BoundaryExtension, FallsOffAroundANode) {
  const Grid grid{64, 64, 1.0, 1.0};
  std::vector<std::uint8_t> is_free(grid.size());
  std::vector<float> residual(grid.size());
  is_free[grid.index(0, 0)] = 2;
  residual[grid.index(0, 0)] = 1.0F;

  const std::vector<float> field = extended(grid, 1.0, is_free, residual);

  EXPECT_EQ(field[grid.index(0, 0)], 1.0F);
  EXPECT_GT(field[grid.index(63, 63)], 0.05F);
  for (const int near : {1, 2, 4}) {
    const float beside = field[grid.index(near, 0)];
    const float far = field[grid.index(4 * near, 0)];
    EXPECT_LT(beside, 0.9F);
    EXPECT_GT(far, 0.125F * beside) << near;
    EXPECT_LT(far, 0.5F * beside) << near;
  }
}

// Mirror images do not bring the opposite corner near.
TEST(BoundaryExtension, FallsOffToTheOppositeCornerOfMirrorImages) {
  const Grid grid{64, 64, 1.0, 1.0};
  std::vector<std::uint8_t> is_free(grid.size());
  std::vector<float> residual(grid.size());
  is_free[grid.index(0, 0)] = 2;
  residual[grid.index(0, 0)] = 1.0F;

  const std::vector<float> field =
      extended(grid, 1.0, is_free, residual, Continuation::mirrored);

  EXPECT_GT(field[grid.index(1, 1)], 0.3F);
  EXPECT_LT(field[grid.index(63, 63)], 0.02F);
  EXPECT_LT(field[grid.index(63, 0)], 0.05F);
  EXPECT_LT(field[grid.index(0, 63)], 0.05F);
}

// Verifies that fold is the transpose of extend, also after nodes have become
// active, on even and odd sides, on one thread and on two, of both
// continuations: (E r) . y = r . (E^T y). Tolerance: single precision of sums
// of some thousand terms.
class FoldOfExtension : public testing::TestWithParam<Continuation> {};

TEST_P(FoldOfExtension, IsItsTranspose) {
  for (const Grid& grid :
       {Grid{72, 80, 1.0, 1.0}, Grid{71, 45, 1.0, 1.0}, Grid{30, 33, 1.0, 1.0},
        Grid{90, 1, 1.0, 1.0}, Grid{1, 2, 1.0, 1.0}, Grid{3, 5, 1.0, 1.0}})
    for (const int threads : {1, 2}) {
      std::vector<std::uint8_t> is_free = patches(grid);
      BoundaryExtension extension(grid, threads, GetParam());
      extension.build(share, is_free);
      for (std::size_t i = 0; i < grid.size(); i += 37)
        is_free[i] = 1;
      std::vector<float> r = random_field(grid.size(), 1);
      std::vector<float> y = random_field(grid.size(), 2);
      for (std::size_t i = 0; i < grid.size(); ++i)
        if (is_free[i] == 0)
          r[i] = 0.0F;
      const std::vector<float> whole_y = y;
      std::vector<float> field(grid.size());

      const BlockFlags blocks = blocks_with(is_free);
      extension.extend({is_free, blocks}, r, field);
      extension.fold({is_free, blocks}, y);

      double left = 0.0, right = 0.0, size = 0.0;
      for (std::size_t i = 0; i < grid.size(); ++i) {
        left += static_cast<double>(field[i]) * static_cast<double>(whole_y[i]);
        right += static_cast<double>(r[i]) * static_cast<double>(y[i]);
        size += std::abs(static_cast<double>(field[i] * whole_y[i]));
      }
      EXPECT_NEAR(left, right, 1e-6 * size);
      EXPECT_GT(size, 0.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Continuations, FoldOfExtension,
                         testing::Values(Continuation::periodic,
                                         Continuation::mirrored));

} // namespace asperity::contact::boundary_extension_test
