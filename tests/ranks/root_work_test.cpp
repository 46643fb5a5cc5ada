// Claims: what rank 0 does alone, and what it finds, is done and known once for
// all ranks; its failures are failures of all ranks, none of which waits.
#include "base/ranks/root_work.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::root_work_test {

constexpr int n_ranks = 3;

std::string failure_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "none";
}

TEST(RootWork, GivesWhatRank0FindsToAll) {
  tests::on_thread_ranks(n_ranks, [](ProgramRanks& ranks) {
    RootWork root(&ranks);

    const int number = root.value([&] { return 7 + ranks.rank(); });
    const std::vector<double> numbers = root.value([] {
      return std::vector{1.5, 2.5};
    });
    const std::string none = root.value([] { return std::string(); });

    EXPECT_EQ(number, 7);
    EXPECT_EQ(numbers, (std::vector{1.5, 2.5}));
    EXPECT_EQ(none, "");
  });
}

TEST(RootWork, FailsOnAllRanksIfRank0Fails) {
  tests::on_thread_ranks(n_ranks, [](ProgramRanks& ranks) {
    RootWork root(&ranks);
    const std::string plain = failure_of(
        [&] { root.act([] { throw std::domain_error("no file"); }); });

    EXPECT_EQ(plain, ranks.rank() == 0 ? "no file" : "rank 0 failed");
    EXPECT_EQ(root.value([] { return 3; }), 3); // all ranks go on together
  });
}

TEST(RootWork, IsAPlainCallInOneProcess) {
  RootWork alone;
  int calls = 0;

  alone.act([&] { ++calls; });

  EXPECT_EQ(calls, 1);
  EXPECT_TRUE(alone.is_root());
  EXPECT_EQ(alone.value([] { return 4; }), 4);
  EXPECT_EQ(failure_of(
                [&] { alone.act([] { throw std::domain_error("no file"); }); }),
            "no file");
}

} // namespace asperity::root_work_test
