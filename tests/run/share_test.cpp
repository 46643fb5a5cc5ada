// Tests of how members are divided among parts: every member exactly once, with
// balanced costs, and the same on every machine.
#include "input/input_error.hpp"
#include "run/distributed/share.hpp"

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace asperity::run::share_test {

using Shares = std::vector<std::vector<std::size_t>>;

double cost_of_part(const std::vector<std::size_t>& part,
                    const std::vector<double>& costs) {
  double sum = 0.0;
  for (const std::size_t member : part)
    sum += costs[member];
  return sum;
}

RC_GTEST_PROP(Shares, HoldEveryMemberOnce, ()) {
  const auto whole =
      *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000));
  const std::vector<double> costs(whole.begin(), whole.end());
  const int n_parts = *rc::gen::inRange(1, 20);

  const Shares parts = shares(costs, n_parts);

  std::vector<std::size_t> members;
  for (const std::vector<std::size_t>& part : parts) {
    RC_ASSERT(std::ranges::is_sorted(part));
    members.insert(members.end(), part.begin(), part.end());
  }
  std::ranges::sort(members);
  std::vector<std::size_t> all(costs.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  RC_ASSERT(members == all);
}

// Costs are integers, so that their sums are exact.
RC_GTEST_PROP(Shares, DifferByAtMostOneMember, ()) {
  const auto whole =
      *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 1000));
  const std::vector<double> costs(whole.begin(), whole.end());
  const int n_parts = *rc::gen::inRange(1, 20);

  std::vector<double> sums;
  for (const std::vector<std::size_t>& part : shares(costs, n_parts))
    sums.push_back(cost_of_part(part, costs));

  const auto [least, most] = std::ranges::minmax(sums);
  const double largest = costs.empty() ? 0.0 : *std::ranges::max_element(costs);
  RC_ASSERT(most - least <= largest);
}

TEST(EqualMembers, AreDealtInTurn) {
  EXPECT_EQ(shares(std::vector<double>(5, 3.0), 2),
            (Shares{{0, 2, 4}, {1, 3}}));
  EXPECT_EQ(shares({0.0, 0.0, 0.0}, 3), (Shares{{0}, {1}, {2}}));
}

// The points of a sweep over the grid, whose last key varies fastest, would
// all be on one part if they were dealt in turn.
TEST(UnequalMembers, AreBalanced) {
  EXPECT_EQ(shares({1.0, 16.0, 1.0, 16.0}, 2), (Shares{{0, 1}, {2, 3}}));
}

TEST(SharesOfNothing, AreRefused) {
  EXPECT_THROW(shares({1.0}, 0), std::domain_error);
  EXPECT_THROW(shares({-1.0}, 1), std::domain_error);
}

TEST(PartText, IsReadAndWritten) {
  EXPECT_EQ(read_part("3/8"), (Part{3, 8}));
  EXPECT_EQ(read_part("1/1"), (Part{1, 1}));
  EXPECT_EQ(part_text({3, 8}), "3/8");
  for (const char* wrong : {"", "3", "3/", "/8", "0/8", "9/8", "-1/8", "3/-8",
                            "3 / 8", "3/8/9", "a/b", "1.5/3", "99999999999/1"})
    EXPECT_THROW(read_part(wrong), input::InputError) << wrong;
}

} // namespace asperity::run::share_test
