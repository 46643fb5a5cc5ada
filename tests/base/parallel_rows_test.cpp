// Claims about base/parallel_rows.hpp.
#include "base/parallel_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <set>
#include <thread>
#include <vector>

namespace asperity {
namespace {

TEST(ParallelRows, DoesEachRowOnce) {
  for (const int threads : {1, 2, 7, 300})
    for (const int n_rows : {0, 1, 5, 200}) {
      std::vector<int> times(static_cast<std::size_t>(n_rows));

      parallel_rows(n_rows, threads,
                    [&](int row) { ++times[static_cast<std::size_t>(row)]; });

      EXPECT_EQ(std::count(times.begin(), times.end(), 1), n_rows)
          << threads << " threads";
    }
}

TEST(ParallelRows, StartsNoThreadForOne) {
  std::set<std::thread::id> seen;

  parallel_rows(5, 1, [&](int) { seen.insert(std::this_thread::get_id()); });

  EXPECT_EQ(seen, std::set{std::this_thread::get_id()});
}

// Claim: two threads work at the same time: each of two rows waits for the
// other to have begun.
TEST(ParallelRows, WorksOnSeveralThreads) {
  std::atomic<int> begun = 0;

  parallel_rows(2, 2, [&](int) {
    ++begun;
    while (begun < 2)
      std::this_thread::yield();
  });

  EXPECT_EQ(begun, 2);
}

} // namespace
} // namespace asperity
