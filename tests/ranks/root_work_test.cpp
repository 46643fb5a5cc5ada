// Claims: what rank 0 does alone, and what it finds, is done and known once for
// all ranks; its failures are failures of all ranks, none of which waits.
#include "ranks/root_work.hpp"
#include "tests/ranks/thread_ranks.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace asperity::root_work_test {

constexpr int n_ranks = 3;

/// Passes the numbers of all ranks to rank 0.
RootWork::Rows rows_of(RankGroup& ranks, double own) {
  return [&ranks, own](const RootWork::Take& take) {
    const std::vector<std::size_t> bytes(n_ranks, sizeof(double));
    std::vector<double> all(n_ranks);
    ranks.gather_to_all(std::as_bytes(std::span(&own, 1)), bytes,
                        std::as_writable_bytes(std::span(all)));
    if (ranks.rank() == 0)
      for (const double& one : all)
        take(std::span(&one, 1));
  };
}

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

TEST(RootWork, PassesRowsOfAllRanksWhenRank0AsksForThem) {
  tests::on_thread_ranks(n_ranks, [](ProgramRanks& ranks) {
    RootWork root(&ranks);
    const RootWork::Rows first = root.shared(rows_of(ranks, ranks.rank()));
    const RootWork::Rows second =
        root.shared(rows_of(ranks, 10.0 * ranks.rank()));
    const RootWork::Rows unused = root.shared(rows_of(ranks, 5.0));
    std::vector<double> taken;
    const auto take = [&](std::span<const double> values) {
      taken.insert(taken.end(), values.begin(), values.end());
    };

    root.act([&] {
      second(take);
      first(take);
      second(take);
    });

    const std::vector<double> all{0, 10, 20, 0, 1, 2, 0, 10, 20};
    EXPECT_EQ(taken, ranks.rank() == 0 ? all : std::vector<double>());
  });
}

TEST(RootWork, FailsOnAllRanksIfRank0Fails) {
  tests::on_thread_ranks(n_ranks, [](ProgramRanks& ranks) {
    RootWork root(&ranks);
    const RootWork::Rows rows = root.shared(rows_of(ranks, 1.0));

    const std::string plain = failure_of(
        [&] { root.act([] { throw std::domain_error("no file"); }); });
    const RootWork::Rows again = root.shared(rows_of(ranks, 1.0));
    const std::string taking = failure_of([&] {
      root.act([&] {
        again([](std::span<const double>) {
          throw std::domain_error("no space");
        });
      });
    });

    EXPECT_EQ(plain, ranks.rank() == 0 ? "no file" : "rank 0 failed");
    EXPECT_EQ(taking, ranks.rank() == 0 ? "no space" : "rank 0 failed");
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
