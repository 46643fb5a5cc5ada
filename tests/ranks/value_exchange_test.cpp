// Tests of base/ranks/value_exchange.hpp on ranks that are threads.
#include "base/ranks/value_exchange.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

namespace asperity::value_exchange_test {

/// The values of a rank: as many as its number, 10 times it and upwards.
std::vector<double> values_of(int rank) {
  std::vector<double> values;
  for (int i = 0; i < rank; ++i)
    values.push_back(10.0 * rank + i);
  return values;
}

// Verifies that values go to their targets in the order of the ranks, and come
// back to their places. Rank r sends its value i to rank i.
TEST(ValueExchange, SendsEachValueToOneRankAndBack) {
  tests::on_thread_ranks(4, [](RankGroup& ranks) {
    const std::vector<double> own = values_of(ranks.rank());
    std::vector<int> targets;
    for (int i = 0; i < ranks.rank(); ++i)
      targets.push_back(i);
    const ValueExchange exchange(ranks, targets);

    std::vector<double> found = exchange.sent(std::span<const double>(own));

    std::vector<double> expected;
    for (int r = ranks.rank() + 1; r < 4; ++r)
      expected.push_back(10.0 * r + ranks.rank());
    EXPECT_EQ(found, expected);
    EXPECT_EQ(exchange.n_received(), expected.size());
    EXPECT_EQ(exchange.returned(std::span<const double>(found)), own);
  });
}

TEST(ValueExchange, SendsAllValuesToEveryRankAndBack) {
  tests::on_thread_ranks(3, [](RankGroup& ranks) {
    const std::vector<double> own = values_of(ranks.rank());
    const ValueExchange exchange(ranks, own.size());

    const std::vector<double> found =
        exchange.sent(std::span<const double>(own));

    EXPECT_EQ(found, (std::vector<double>{10.0, 20.0, 21.0}));
    EXPECT_EQ(exchange.returned(std::span<const double>(found)), own);
  });
}

TEST(ValueExchange, RefusesTargetsThatDecrease) {
  tests::on_thread_ranks(2, [](RankGroup& ranks) {
    const std::vector<int> targets{1, 0};
    EXPECT_THROW(ValueExchange(ranks, targets), std::domain_error);
  });
}

} // namespace asperity::value_exchange_test
