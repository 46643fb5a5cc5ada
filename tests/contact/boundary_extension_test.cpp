// Tests of contact/solvers/boundary_extension.hpp.
#include "contact/solvers/boundary_extension.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace asperity::contact {
namespace {

constexpr double reach = 0.6;

std::vector<std::uint8_t> patches(const Grid& grid) {
  std::vector<std::uint8_t> is_free(grid.size());
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      is_free[grid.index(ix, iy)] =
          std::sin(0.7 * ix) + std::cos(0.9 * iy) > 0.8 ? 2 : 0;
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

// Verifies (R.1) around a single node: 0.6 on its eight neighbours, 0.36 on
// most of the next layer. clear() removes all of it.
TEST(BoundaryExtension, FallsOffLayerByLayer) {
  const Grid grid{16, 16, 1.0, 1.0};
  std::vector<std::uint8_t> is_free(grid.size());
  std::vector<float> field(grid.size());
  is_free[grid.index(0, 0)] = 2; // on the edge: the layers wrap around
  field[grid.index(0, 0)] = 1.0F;
  BoundaryExtension extension(grid, 1);
  extension.build(is_free);

  extension.extend(reach, is_free, field);

  EXPECT_NEAR(static_cast<double>(field[grid.index(15, 15)]), 0.6, 1e-6);
  EXPECT_NEAR(static_cast<double>(field[grid.index(2, 14)]), 0.36, 1e-6);
  EXPECT_NEAR(static_cast<double>(field[grid.index(3, 0)]), 0.216, 1e-6);
  EXPECT_EQ(field[grid.index(4, 0)], 0.0F);
  extension.clear(is_free, field);
  field[grid.index(0, 0)] = 0.0F;
  EXPECT_EQ(field, std::vector<float>(grid.size()));
}

// Verifies that fold is the transpose of extend, also after nodes have become
// active, on one thread and on two: (E r) . y = r . (E^T y). Tolerance: single
// precision of sums of some hundred terms.
TEST(BoundaryExtension, FoldIsItsTranspose) {
  const Grid grid{24, 20, 1.0, 1.0};
  for (const int threads : {1, 2}) {
    std::vector<std::uint8_t> is_free = patches(grid);
    BoundaryExtension extension(grid, threads);
    extension.build(is_free);
    for (std::size_t i = 0; i < grid.size(); i += 7)
      is_free[i] = 1;
    std::vector<float> r = random_field(grid.size(), 1);
    std::vector<float> y = random_field(grid.size(), 2);
    for (std::size_t i = 0; i < grid.size(); ++i)
      if (is_free[i] == 0)
        r[i] = 0.0F;
    const std::vector<float> whole_y = y;
    std::vector<float> extended = r;

    extension.extend(reach, is_free, extended);
    extension.fold(reach, is_free, y);

    double left = 0.0, right = 0.0;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      left +=
          static_cast<double>(extended[i]) * static_cast<double>(whole_y[i]);
      right += static_cast<double>(r[i]) * static_cast<double>(y[i]);
    }
    EXPECT_NEAR(left, right, 1e-4);
    EXPECT_GT(std::abs(left), 1.0);
  }
}

} // namespace
} // namespace asperity::contact
