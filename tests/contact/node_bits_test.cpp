// Tests of contact/solvers/node_bits.hpp against a loop over all nodes.
#include "contact/solvers/node_bits.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace asperity::contact {
namespace {

/// Steps to the eight neighbours in the order of NodeBits::neighbours.
constexpr std::array<std::array<int, 2>, 8> steps = {
    {{-1, 0}, {1, 0}, {0, -1}, {0, 1}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};

/// Half of the flags are 0, the others anything up to 255.
std::vector<std::uint8_t> flags_on(const Grid& grid) {
  std::mt19937 random(7);
  std::vector<std::uint8_t> flags(grid.size());
  for (auto& flag : flags)
    flag = random() % 2 == 0 ? 0 : static_cast<std::uint8_t>(random() % 256);
  return flags;
}

NodeBits bits_of(const SharedRows& rows,
                 const std::vector<std::uint8_t>& flags) {
  const Grid& grid = rows.grid();
  NodeBits bits(rows);
  const auto width = static_cast<std::size_t>(grid.points_x);
  for (int iy = 0; iy < grid.points_y; ++iy)
    bits.assign_row(iy, std::span(flags).subspan(grid.index(0, iy), width));
  return bits;
}

/// Widths of less than a word, of entire words, and of a word and a remainder.
std::vector<Grid> grids() {
  std::vector<Grid> all;
  for (const int width : {1, 2, 7, 63, 64, 65, 96, 128, 130})
    for (const int height : {1, 2, 5})
      all.push_back({width, height, 1.0, 1.0});
  return all;
}

TEST(NodeBits, HoldTheFlags) {
  for (const Grid& grid : grids()) {
    const std::vector<std::uint8_t> flags = flags_on(grid);

    const SharedRows rows(grid);
    NodeBits bits = bits_of(rows, flags);
    bits.fill_ghost_rows();

    for (int iy = 0; iy < grid.points_y; ++iy)
      for (int ix = 0; ix < 64 * bits.words_a_row(); ++ix) {
        const bool is_node = ix < grid.points_x;
        const bool is_border = ix == 0 || ix + 1 == grid.points_x || iy == 0 ||
                               iy + 1 == grid.points_y;
        EXPECT_EQ(bits.at(iy, ix / 64) >> ix % 64 & 1U,
                  is_node && flags[grid.index(ix, iy)] > 0 ? 1U : 0U);
        EXPECT_EQ(bits.valid(ix / 64) >> ix % 64 & 1U, is_node ? 1U : 0U);
        EXPECT_EQ(bits.border(iy, ix / 64) >> ix % 64 & 1U,
                  is_node && is_border ? 1U : 0U)
            << ix << " of " << grid.points_x;
      }
  }
}

TEST(NodeBits, HaveThePeriodicNeighbours) {
  for (const Grid& grid : grids()) {
    const std::vector<std::uint8_t> flags = flags_on(grid);

    const SharedRows rows(grid);
    NodeBits bits = bits_of(rows, flags);
    bits.fill_ghost_rows();

    for (int iy = 0; iy < grid.points_y; ++iy)
      for (int ix = 0; ix < grid.points_x; ++ix)
        for (std::size_t k = 0; k < steps.size(); ++k) {
          const int to_x = (ix + steps[k][0] + grid.points_x) % grid.points_x;
          const int to_y = (iy + steps[k][1] + grid.points_y) % grid.points_y;
          EXPECT_EQ(bits.neighbours(iy, ix / 64)[k] >> ix % 64 & 1U,
                    flags[grid.index(to_x, to_y)] > 0 ? 1U : 0U)
              << "neighbour " << k << " of " << ix << ", " << iy << " on "
              << grid.points_x << " by " << grid.points_y;
        }
  }
}

} // namespace
} // namespace asperity::contact
