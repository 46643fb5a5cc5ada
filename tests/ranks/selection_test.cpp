// Tests of ranks/selection.hpp against sorting. Tolerance: none.
#include "ranks/selection.hpp"
#include "ranks/shared_rows.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace asperity::selection_test {

/// Numbers of all magnitudes and both signs, many of them equal.
std::vector<double> some_numbers() {
  const double infinity = std::numeric_limits<double>::infinity();
  const double tiny = std::numeric_limits<double>::denorm_min();
  std::vector<double> numbers{infinity, -infinity, 0.0,  tiny, -tiny, 1e308,
                              -1e308,   1.0,       -1.0, 1.0,  1.0};
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i)
    numbers.push_back(normal(random) * std::pow(10.0, i % 40 - 20));
  for (int i = 0; i < 100; ++i)
    numbers.push_back(std::nextafter(1.0, i % 3));
  return numbers;
}

TEST(Selection, IsThatOfSortedNumbersOnAnyNumberOfRanks) {
  const std::vector<double> numbers = some_numbers();
  std::vector<double> sorted = numbers;
  std::ranges::sort(sorted);
  for (int n = 1; n <= 4; ++n)
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      // Rank 1 has no numbers.
      std::vector<double> own;
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        const int owner = static_cast<int>(i * i) % n;
        if ((owner == 1 ? 0 : owner) == ranks.rank())
          own.push_back(numbers[i]);
      }
      for (std::size_t k = 0; k < sorted.size(); ++k)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(kth_smallest(&ranks, own, k)),
                  std::bit_cast<std::uint64_t>(sorted[k]))
            << k;
      EXPECT_THROW(kth_smallest(&ranks, own, sorted.size()), std::domain_error);
    });
}

TEST(Selection, PutsNaNAtTheEnd) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> numbers{nan, 2.0, -nan, 1.0};
  EXPECT_EQ(kth_smallest(nullptr, numbers, 1), 1.0);
  EXPECT_EQ(kth_smallest(nullptr, numbers, 2), 2.0);
  EXPECT_TRUE(std::isnan(kth_smallest(nullptr, numbers, 0)));
  EXPECT_TRUE(std::isnan(kth_smallest(nullptr, numbers, 3)));
}

TEST(Median, IsTheMeanOfTheMiddleTwo) {
  EXPECT_EQ(median(nullptr, std::vector{5.0, 1.0, 4.0}), 4.0);
  EXPECT_EQ(median(nullptr, std::vector{5.0, 1.0, 4.0, 2.0}), 3.0);
  EXPECT_EQ(median(nullptr, std::vector(7, -0.5)), -0.5);
  EXPECT_TRUE(std::isnan(median(nullptr, {})));
}

// Each rank asks for other rows, also for none and for all of them.
TEST(RowsAt, AreThoseOfTheWholeField) {
  const Grid grid{3, 9, 3.0, 9.0};
  std::vector<double> whole(grid.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
    whole[i] = static_cast<double>(i);
  for (int n = 1; n <= 4; ++n)
    tests::on_thread_ranks(n, [&](RankGroup& ranks) {
      std::vector<int> bounds{0};
      for (int r = 1; r < n; ++r)
        bounds.push_back(r * r); // ranks of one row and of more
      bounds.push_back(grid.points_y);
      if (n == 4)
        bounds[3] = 8;
      const SharedRows rows(grid, ranks, bounds);
      const auto own =
          std::span(whole).subspan(grid.index(0, rows.first()), rows.size());
      for (int first = 0; first < grid.points_y; ++first) {
        const int from = (first + 2 * ranks.rank()) % grid.points_y;
        const int count = (grid.points_y - from + ranks.rank()) % 10;
        const int kept = std::min(count, grid.points_y - from);
        const std::vector<double> found = rows.rows_at(own, from, kept);
        EXPECT_TRUE(std::ranges::equal(
            found,
            std::span(whole).subspan(grid.index(0, from),
                                     static_cast<std::size_t>(3 * kept))))
            << from << " " << kept;
      }
      const std::vector<double> all = rows.rows_at(own, 0, grid.points_y);
      EXPECT_EQ(all, whole);
    });
}

} // namespace asperity::selection_test
