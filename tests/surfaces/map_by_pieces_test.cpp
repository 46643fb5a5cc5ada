// Tests of what is found of a map that is passed on by pieces, against the same
// of a map in memory.
#include "surfaces/assumptions.hpp"
#include "surfaces/maps/shells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::surfaces::map_by_pieces_test {

/// A map without symmetries.
HeightMap uneven_map(const Grid& grid) {
  HeightMap map{grid, {}};
  for (std::size_t i = 0; i < grid.size(); ++i)
    map.heights.push_back(
        1e-6 * std::sin(1e-3 * static_cast<double>(i * i % 10007)) +
        1e-9 *
            static_cast<double>(i / static_cast<std::size_t>(grid.points_x)));
  return map;
}

HeightRows in_pieces(const HeightMap& map, std::size_t rows, int& passes) {
  return [&map, rows, &passes](const auto& take) {
    ++passes;
    const auto width = static_cast<std::size_t>(map.grid.points_x);
    for (std::size_t at = 0; at < map.heights.size(); at += rows * width)
      take(std::span(map.heights)
               .subspan(at, std::min(rows * width, map.heights.size() - at)));
  };
}

void expect_same(const std::vector<Shell>& found,
                 const std::vector<Shell>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].wavevector, expected[i].wavevector) << i;
    ASSERT_EQ(found[i].mean_square_height, expected[i].mean_square_height) << i;
    ASSERT_EQ(found[i].modes, expected[i].modes) << i;
  }
}

// Odd sides, an even number of rows at a time, and a last piece of one row.
TEST(MapByPieces, HasTheShellsOfTheMapInMemory) {
  for (const Grid& grid : {Grid{60, 45, 3e-6, 2e-6}, Grid{45, 61, 3e-6, 3e-6},
                           Grid{64, 64, 1e-6, 1e-6}}) {
    const HeightMap map = uneven_map(grid);
    for (const std::size_t rows : {4U, 20U, 100U})
      for (const int threads : {1, 3}) {
        int passes = 0;
        expect_same(
            spectral_shells(grid, in_pieces(map, rows, passes), threads, 1e-6),
            spectral_shells(map, 1e-6));
        EXPECT_EQ(passes, 1);
      }
  }
}

// The columns are 9 % more than what is in memory at a time.
TEST(MapByPieces, IsReadTwiceIfItsColumnsAreMany) {
  const Grid grid{2200, 4160, 2.2e-6, 4.16e-6};
  const HeightMap map = uneven_map(grid);
  int passes = 0;
  expect_same(spectral_shells(grid, in_pieces(map, 1024, passes), 2),
              spectral_shells(map));
  EXPECT_EQ(passes, 2);
}

// Pieces of four rows, and one piece: the same bits.
TEST(MapByPieces, HasTheMeasuresOfTheMapInMemory) {
  const Grid grid{60, 45, 3e-6, 2e-6};
  const HeightMap map = uneven_map(grid);
  int passes = 0;
  const double share = unresolved_slope_share(grid, in_pieces(map, 45, passes));
  ASSERT_GT(share, 0.1);
  EXPECT_EQ(unresolved_slope_share(grid, in_pieces(map, 4, passes)), share);
  EXPECT_EQ(line_offset_ratio(grid, in_pieces(map, 4, passes)),
            line_offset_ratio(grid, in_pieces(map, 45, passes)));
}

} // namespace asperity::surfaces::map_by_pieces_test
