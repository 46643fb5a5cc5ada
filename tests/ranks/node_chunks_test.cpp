// Tests of the division of nodes into chunks. Tolerance: none.
#include "ranks/node_chunks.hpp"
#include "ranks/workers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace asperity::node_chunks_test {

std::vector<std::size_t> begins_of(const NodeChunks& chunks,
                                   std::size_t nodes) {
  std::vector<std::size_t> begins;
  for (std::size_t chunk = 0; chunk < chunks.count(nodes); ++chunk)
    begins.push_back(chunks.begin(chunk));
  return begins;
}

std::vector<Grid> grids() {
  std::vector<Grid> all;
  for (const int points_x :
       {1, 3, 100, 500, 513, 600, 768, 1000, 1001, 1009, 1200, 2000, 5001})
    for (const int points_y : {1, 257, 1000, 8000})
      all.push_back({points_x, points_y, 1.0, 1.0});
  return all;
}

TEST(NodeChunks, HaveAFixedSizeIfThePointsAreAPowerOfTwo) {
  for (int points = 1; points <= 65536; points *= 2) {
    const Grid grid{points, points, 1.0, 1.0};
    const NodeChunks chunks(grid);
    EXPECT_EQ(chunks.count(grid.size()),
              (grid.size() + chunk_nodes - 1) / chunk_nodes);
    for (std::size_t chunk = 0; chunk < 40; ++chunk)
      EXPECT_EQ(chunks.begin(chunk), chunk * chunk_nodes);
  }
}

// Means of 2/3 to 4/3 chunk_nodes, and up to 64 nodes more or less; units of 64
// rows of an odd width, or of 8 rows, are larger at least if they are divided.
TEST(NodeChunks, BeginAtWholeBlocksAndAreAboutEqual) {
  for (const Grid& grid : grids()) {
    const NodeChunks chunks(grid);
    EXPECT_EQ(chunks.unit_nodes() %
                  (rows_in_cell * static_cast<std::size_t>(grid.points_x)),
              0U);
    for (std::size_t chunk = 0; chunk < 3 * chunks.in_unit(); ++chunk) {
      const std::size_t begin = chunks.begin(chunk);
      const std::size_t size = chunks.begin(chunk + 1) - begin;
      EXPECT_EQ(begin % chunk_alignment, 0U) << grid.points_x;
      EXPECT_GE(size + chunk_alignment, 2 * chunk_nodes / 3) << grid.points_x;
      EXPECT_LE(size, 4 * chunk_nodes / 3 + chunk_alignment) << grid.points_x;
    }
  }
}

TEST(NodeChunks, CoverAllNodesInAtMostTheLargestNumberOfGroups) {
  for (const Grid& grid : grids()) {
    const NodeChunks chunks(grid);
    const std::size_t n = chunks.count(grid.size());
    EXPECT_LT(chunks.begin(n - 1), grid.size());
    EXPECT_GE(chunks.begin(n), grid.size());
    EXPECT_LE(chunks.groups(grid.size(), grid.size()), most_groups);
  }
}

// The chunks of the ranks, one rank after the other, are those of one process,
// and so are the groups.
TEST(NodeChunks, OfAllRanksAreThoseOfOneProcess) {
  for (const Grid& grid : grids()) {
    const NodeChunks chunks(grid);
    for (const int n : {2, 3, 7})
      if (n <= most_ranks(grid)) {
        const std::vector<int> bounds = row_bounds(grid, n);
        std::vector<std::size_t> begins;
        std::size_t groups = 0;
        for (std::size_t r = 0; r + 1 < bounds.size(); ++r) {
          EXPECT_EQ(begins.size() % chunks.in_group(grid.size()), 0U);
          const std::size_t first = grid.index(0, bounds[r]);
          const std::size_t nodes = grid.index(0, bounds[r + 1]) - first;
          for (const std::size_t begin : begins_of(chunks, nodes))
            begins.push_back(first + begin);
          groups += chunks.groups(nodes, grid.size());
        }
        EXPECT_EQ(begins, begins_of(chunks, grid.size()))
            << grid.points_x << " by " << grid.points_y;
        EXPECT_EQ(groups, chunks.groups(grid.size(), grid.size()));
      }
  }
}

// Common sizes of measured maps can be divided.
TEST(NodeChunks, AllowManyRanks) {
  const auto most = [](int points) {
    return most_ranks({points, points, 1.0, 1.0});
  };
  EXPECT_EQ(most(1000), 125);
  EXPECT_EQ(most(1024), 128);
  for (int points = 512; points < 1200; ++points)
    EXPECT_GE(most(points), 8) << points;
}

// Shares of 1000 rows are nearly equal, and remain shared on coarser grids.
TEST(NodeChunks, AllowCoarserGridsToBeShared) {
  const Grid grid{1000, 1000, 1.0, 1.0};
  for (const int n : {2, 3, 4}) {
    std::vector<int> bounds = row_bounds(grid, n);
    for (int& bound : bounds)
      bound /= 2;
    EXPECT_TRUE(holds_whole_groups({500, 500, 1.0, 1.0}, bounds)) << n;
  }
}

} // namespace asperity::node_chunks_test
