// Tests of contact/solvers/boundary_extension.hpp.
#include "contact/solvers/boundary_extension.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace asperity::contact {
namespace {

constexpr double share = 0.9;

std::vector<std::uint8_t> patches(const Grid& grid) {
  std::vector<std::uint8_t> is_free(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      is_free[grid.index(ix, iy)] =
          std::sin(0.2 * ix) + std::cos(0.3 * iy) > 0.8 ? 2 : 0;
  return is_free;
}

std::vector<float> random_field(std::size_t size, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> value(-1.0F, 1.0F);
  std::vector<float> field(size);
  for (float& entry : field)
    entry = value(random);
  return field;
}

std::vector<float> extended(const Grid& grid,
                            const std::vector<std::uint8_t>& is_free,
                            const std::vector<float>& residual) {
  BoundaryExtension extension(grid, 1);
  extension.build(is_free);
  std::vector<float> field(grid.size(), 7.0F);
  extension.extend(share, is_free, residual, field);
  return field;
}

// If every cell of 2 by 2 nodes has an active one, all means of a uniform
// residual are equal, and bilinear interpolation keeps a uniform field: (R.1)
// is share gain_0 at each inactive node. Odd sides end with narrower cells.
TEST(BoundaryExtension, KeepsAUniformResidualInsideAndScalesItOutside) {
  for (const Grid& grid :
       {Grid{16, 16, 1.0, 1.0}, Grid{13, 9, 1.0, 1.0}, Grid{24, 1, 1.0, 1.0}}) {
    std::vector<std::uint8_t> is_free(grid.size());
    std::vector<float> residual(grid.size());
    for (int iy = 0; iy < grid.points_y; iy += 2)
      for (int ix = 0; ix < grid.points_x; ix += 2) {
        is_free[grid.index(ix, iy)] = 2;
        residual[grid.index(ix, iy)] = 3.0F;
      }

    const std::vector<float> field = extended(grid, is_free, residual);

    const double outside =
        share * static_cast<double>(BoundaryExtension::gains[0]) * 3.0;
    for (std::size_t i = 0; i < grid.size(); ++i)
      EXPECT_NEAR(static_cast<double>(field[i]), is_free[i] > 0 ? 3.0 : outside,
                  1e-5);
  }
}

// Around one active node on the edge of the grid the field wraps around, falls
// off, and is 0 in cells of level 3 that are no neighbours of its cell.
TEST(BoundaryExtension, FallsOffAroundANode) {
  const Grid grid{64, 64, 1.0, 1.0};
  std::vector<std::uint8_t> is_free(grid.size());
  std::vector<float> residual(grid.size());
  is_free[grid.index(0, 0)] = 2;
  residual[grid.index(0, 0)] = 1.0F;

  const std::vector<float> field = extended(grid, is_free, residual);

  EXPECT_EQ(field[grid.index(0, 0)], 1.0F);
  const float beside = field[grid.index(1, 0)];
  EXPECT_GT(beside, 0.5F);
  EXPECT_LT(beside, 0.9F);
  EXPECT_GT(field[grid.index(63, 63)], 0.0F);
  EXPECT_LT(field[grid.index(6, 0)], 0.5F * beside);
  EXPECT_GT(field[grid.index(6, 0)], 0.0F);
  EXPECT_EQ(field[grid.index(32, 0)], 0.0F);
  EXPECT_EQ(field[grid.index(0, 32)], 0.0F);
}

// Verifies that fold is the transpose of extend, also after nodes have become
// active, on even and odd sides, on one thread and on two: (E r) . y = r . (E^T
// y). Tolerance: single precision of sums of some thousand terms.
TEST(BoundaryExtension, FoldIsItsTranspose) {
  for (const Grid& grid :
       {Grid{72, 80, 1.0, 1.0}, Grid{71, 45, 1.0, 1.0}, Grid{30, 33, 1.0, 1.0},
        Grid{90, 1, 1.0, 1.0}, Grid{1, 2, 1.0, 1.0}, Grid{3, 5, 1.0, 1.0}})
    for (const int threads : {1, 2}) {
      std::vector<std::uint8_t> is_free = patches(grid);
      BoundaryExtension extension(grid, threads);
      extension.build(is_free);
      for (std::size_t i = 0; i < grid.size(); i += 37)
        is_free[i] = 1;
      std::vector<float> r = random_field(grid.size(), 1);
      std::vector<float> y = random_field(grid.size(), 2);
      for (std::size_t i = 0; i < grid.size(); ++i)
        if (is_free[i] == 0)
          r[i] = 0.0F;
      const std::vector<float> whole_y = y;
      std::vector<float> field(grid.size());

      extension.extend(share, is_free, r, field);
      extension.fold(share, is_free, y);

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

} // namespace
} // namespace asperity::contact
