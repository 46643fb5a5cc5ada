// Tests of base/ranks/ghost_values.hpp and rank_sums.hpp: the values of other
// ranks, by threads in place of processes.
#include "base/ranks/ghost_values.hpp"
#include "base/ranks/rank_sums.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace asperity::ghost_values_test {

/// Rank r owns r + 1 items, with the numbers from r (r + 1) / 2, and needs the
/// first item of each other rank.
struct Items {
  std::size_t first, owned;
  std::vector<std::size_t> ghosts;

  explicit Items(const RankGroup& ranks)
      : first(first_of(ranks.rank())),
        owned(static_cast<std::size_t>(ranks.rank()) + 1) {
    for (int r = 0; r < ranks.size(); ++r)
      if (r != ranks.rank())
        ghosts.push_back(first_of(r));
  }

  static std::size_t first_of(int rank) {
    return static_cast<std::size_t>(rank * (rank + 1) / 2);
  }
};

constexpr double elsewhere = -7.0; // a number that concerns no other rank

template <class Number>
void check(RankGroup& ranks) {
  const Items items(ranks);
  const GhostValues values(ranks, items.owned, items.ghosts, 2);
  std::vector<Number> array(2 * (items.owned + items.ghosts.size()) + 1,
                            Number(1));
  array.back() = Number(elsewhere);
  for (std::size_t i = 0; i < 2 * items.owned; ++i)
    array[i] = static_cast<Number>(10 * (2 * items.first + i));

  values.fill_ghosts(array.data());

  for (std::size_t i = 0; i < items.ghosts.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_EQ(array[2 * (items.owned + i) + k],
                static_cast<Number>(10 * (2 * items.ghosts[i] + k)));

  values.add_to_owners(array.data());

  // The first item has been added by each of the other ranks.
  for (std::size_t i = 0; i < 2 * items.owned; ++i)
    EXPECT_EQ(array[i], static_cast<Number>(10 * (2 * items.first + i) *
                                            (i < 2 ? ranks.size() : 1)));
  for (std::size_t i = 2 * items.owned; i + 1 < array.size(); ++i)
    EXPECT_EQ(array[i], Number(0));
  EXPECT_EQ(array.back(), Number(elsewhere));
}

TEST(GhostValues, AreThoseOfTheOwnersAndReturnToThem) {
  for (const int n : {1, 2, 4})
    tests::on_thread_ranks(n, [](RankGroup& ranks) {
      check<float>(ranks);
      check<double>(ranks);
    });
}

TEST(GhostValues, RefuseItemsThatNoOtherRankOwns) {
  tests::on_thread_ranks(2, [](RankGroup& ranks) {
    const std::vector<std::size_t> own{ranks.rank() == 0 ? 0U : 1U}, none{3U};
    EXPECT_THROW(GhostValues(ranks, ranks.rank() == 0 ? 1 : 2, own, 3),
                 std::domain_error);
    EXPECT_THROW(GhostValues(ranks, ranks.rank() == 0 ? 1 : 2, none, 3),
                 std::domain_error);
  });
}

TEST(RankSums, AreThoseOfTheNumbers) {
  tests::on_thread_ranks(3, [](RankGroup& ranks) {
    const double own = std::pow(-2.0, ranks.rank());
    EXPECT_EQ(rank_sum(&ranks, own), 3.0);
    EXPECT_EQ(rank_max(&ranks, own), 4.0);
  });
  EXPECT_EQ(rank_sum(nullptr, 0.1), 0.1);
  EXPECT_EQ(rank_max(nullptr, -0.1), -0.1);
}

} // namespace asperity::ghost_values_test
