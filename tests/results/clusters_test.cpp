// Tests of results/observables/clusters.hpp on pictures, of which every number
// can be counted.
#include "results/observables/clusters.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace asperity::results::clusters_test {

/// Cells of 2 m x 3 m, so that lengths along x and y differ.
struct Picture {
  std::vector<std::string> rows;

  Grid grid() const {
    const auto nx = static_cast<int>(rows.front().size());
    const auto ny = static_cast<int>(rows.size());
    return {nx, ny, 2.0 * nx, 3.0 * ny};
  }

  std::vector<std::uint8_t> set(char inside = '#') const {
    std::vector<std::uint8_t> all;
    for (const std::string& row : rows)
      for (const char letter : row)
        all.push_back(letter == inside ? 1 : 0);
    return all;
  }

  std::vector<Cluster> clusters(Border border = Border::periodic) const {
    return find_clusters(grid(), set(), border);
  }
};

TEST(Clusters, OfAPictureAreCounted) {
  const Picture picture{{"##...#", "......", "..##..", "..#...", "...#.."}};

  const std::vector<Cluster> free = picture.clusters(Border::free);
  const std::vector<Cluster> periodic = picture.clusters();

  ASSERT_EQ(free.size(), 4U); // nodes that meet at a corner are not joined
  EXPECT_EQ(free[0].nodes, 2U);
  EXPECT_EQ(free[0].area, 12.0);
  EXPECT_EQ(free[0].perimeter, 2 * 2 * 2.0 + 2 * 3.0);
  EXPECT_EQ(free[2].nodes, 3U);
  EXPECT_EQ(free[2].perimeter, 4 * 2.0 + 4 * 3.0);
  ASSERT_EQ(periodic.size(), 3U); // those of the first row are joined
  EXPECT_EQ(periodic[0].nodes, 3U);
  EXPECT_EQ(periodic[0].perimeter, 2 * 3 * 2.0 + 2 * 3.0);
  EXPECT_FALSE(periodic[0].spans_x);
}

// A band that closes after it has gone around in x and y, a spot across all
// four corners, which goes around neither, and a stripe.
TEST(Clusters, SpanAPeriodicMapIfTheyReturnAPeriodFurther) {
  const Picture diagonal{{"##..", ".##.", "..##", "#..#"}};
  const Picture corner{{"#.#", "...", "#.#"}};
  const Picture stripe{{"..#.", ".##.", ".#..", ".##."}};

  ASSERT_EQ(diagonal.clusters().size(), 1U);
  EXPECT_TRUE(diagonal.clusters()[0].spans_x);
  EXPECT_TRUE(diagonal.clusters()[0].spans_y);
  ASSERT_EQ(corner.clusters().size(), 1U);
  EXPECT_FALSE(corner.clusters()[0].spans_x);
  EXPECT_FALSE(corner.clusters()[0].spans_y);
  ASSERT_EQ(stripe.clusters().size(), 1U);
  EXPECT_FALSE(stripe.clusters()[0].spans_x);
  EXPECT_TRUE(stripe.clusters()[0].spans_y);
}

TEST(Clusters, SpanAMapWithFreeBordersFromSideToSide) {
  const Picture picture{{"#...", "###.", "..##"}};

  const Cluster found = picture.clusters(Border::free).at(0);

  EXPECT_TRUE(found.spans_x);
  EXPECT_TRUE(found.spans_y);
  EXPECT_FALSE((Picture{{"#..#"}}.clusters(Border::free).at(0).spans_x));
  EXPECT_FALSE(
      (Picture{{"#.", "#.", ".."}}.clusters(Border::free).at(0).spans_y));
}

// A full map has no edge and spans in both directions.
TEST(Clusters, OfAFullAndAnEmptyMap) {
  const Picture full{{"##", "##"}};

  const Cluster all = full.clusters().at(0);

  EXPECT_EQ(all.perimeter, 0.0);
  EXPECT_TRUE(all.spans_x && all.spans_y);
  EXPECT_TRUE(find_clusters(full.grid(), full.set('.'), Border::free).empty());
  EXPECT_THROW(find_clusters(full.grid(), std::vector<std::uint8_t>(3),
                             Border::periodic),
               std::domain_error);
}

// Squares of sides 3 to 14 cells: perimeter ~ area^(1/2), D = 1. Combs, whose
// perimeter grows with the area, have D = 2 up to their ends. Tolerances:
// roundoff; the ends are 2 of at least 40 teeth.
TEST(Clusters, HaveTheDimensionOfTheirShape) {
  const int n = 256;
  const Grid grid{n, n, 1.0, 1.0};
  std::vector<std::uint8_t> squares(grid.size()), combs(grid.size());
  for (int k = 3; k < 15; ++k)
    for (int iy = 0; iy < k; ++iy)
      for (int ix = 0; ix < k; ++ix)
        squares[grid.index(17 * (k - 3) + ix, 5 + iy)] = 1;
  for (int k = 0; k < 12; ++k)
    for (int ix = 0; ix < 80 + 10 * k; ++ix) {
      combs[grid.index(ix, 20 * k)] = 1;
      for (int iy = 1; ix % 2 == 0 && iy < 12; ++iy)
        combs[grid.index(ix, 20 * k + iy)] = 1;
    }
  const auto numbers_of = [&](const std::vector<std::uint8_t>& set,
                              std::size_t smallest) {
    return cluster_numbers(find_clusters(grid, set, Border::periodic),
                           smallest);
  };

  EXPECT_NEAR(numbers_of(squares, 1).dimension, 1.0, 1e-12);
  EXPECT_NEAR(numbers_of(combs, 1).dimension, 2.0, 0.02);
  EXPECT_EQ(numbers_of(squares, 1).count, 12.0);
  EXPECT_DOUBLE_EQ(numbers_of(squares, 1).largest, 14.0 * 14.0 / (n * n));
  EXPECT_NEAR(numbers_of(squares, 1).radii,
              (3 + 14) * 6 / (n * std::sqrt(std::acos(-1.0))), 1e-12);
  EXPECT_NEAR(numbers_of(squares, 5 * 5).dimension, 1.0, 1e-12);
  EXPECT_TRUE(std::isnan(numbers_of(squares, 6 * 6).dimension)); // 9 are left
}

// The nodes and edges of all clusters are those of the map, and shifting the
// map by nodes changes no cluster.
RC_GTEST_PROP(Clusters, ShareOutTheMap, ()) {
  const int nx = *rc::gen::inRange(1, 12), ny = *rc::gen::inRange(1, 12);
  const Grid grid{nx, ny, 2.0 * nx, 3.0 * ny};
  const auto set = *rc::gen::container<std::vector<std::uint8_t>>(
      grid.size(), rc::gen::inRange<std::uint8_t>(0, 2));
  const int shift_x = *rc::gen::inRange(0, 12),
            shift_y = *rc::gen::inRange(0, 12);
  std::vector<std::uint8_t> shifted(set.size());
  std::vector<double> pressure(set.begin(), set.end());
  for (int iy = 0; iy < ny; ++iy)
    for (int ix = 0; ix < nx; ++ix)
      shifted[grid.periodic_index(ix + shift_x, iy + shift_y)] =
          set[grid.index(ix, iy)];
  const auto sorted = [&](const std::vector<std::uint8_t>& nodes) {
    std::vector<Cluster> found = find_clusters(grid, nodes, Border::periodic);
    std::ranges::sort(found, {}, [](const Cluster& one) {
      return std::tuple(one.nodes, one.perimeter, one.spans_x, one.spans_y);
    });
    return found;
  };

  const std::vector<Cluster> own = sorted(set), moved = sorted(shifted);

  double nodes = 0.0, perimeter = 0.0;
  RC_ASSERT(own.size() == moved.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    nodes += static_cast<double>(own[i].nodes);
    perimeter += own[i].perimeter;
    RC_ASSERT(own[i].nodes == moved[i].nodes);
    RC_ASSERT(own[i].spans_x == moved[i].spans_x);
    RC_ASSERT(own[i].spans_y == moved[i].spans_y);
  }
  RC_ASSERT(nodes == static_cast<double>(std::ranges::count(set, 1)));
  RC_ASSERT(std::abs(perimeter / grid.area() -
                     contact_perimeter(grid, ContactNodes::under(pressure))) <=
            1e-13);
}

} // namespace asperity::results::clusters_test
