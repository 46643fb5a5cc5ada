// Tests of base/parallel_rows.hpp.
#include "base/parallel_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <new>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace asperity::parallel_rows_test {

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

/// Two rows, each of which waits until the other has begun, and then do_row():
/// only two threads can complete them.
template <class DoRow>
void two_rows_together(const DoRow& do_row) {
  std::atomic<int> begun = 0;
  parallel_rows(2, 2, [&](int) {
    ++begun;
    while (begun < 2)
      std::this_thread::yield();
    do_row();
  });
}

// Two threads work at the same time, and the loop waits for its helper, which
// is slow here.
TEST(ParallelRows, WorksOnSeveralThreadsAndWaits) {
  const std::thread::id caller = std::this_thread::get_id();
  std::atomic<int> done = 0;

  two_rows_together([&] {
    if (std::this_thread::get_id() != caller)
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ++done;
  });

  EXPECT_EQ(done, 2);
}

// Helper threads are reused: twenty loops on two threads use two of them.
TEST(ParallelRows, ReusesItsThreads) {
  std::mutex mutex;
  std::set<pid_t> seen; // not std::thread::id, which new threads take over

  for (int loop = 0; loop < 20; ++loop)
    two_rows_together([&] {
      const std::lock_guard lock(mutex);
      seen.insert(gettid());
    });

  EXPECT_EQ(seen.size(), 2u);
}

int sum_of_rows(int n_rows, int threads) {
  std::vector<int> rows(static_cast<std::size_t>(n_rows));
  parallel_rows(n_rows, threads,
                [&](int row) { rows[static_cast<std::size_t>(row)] = row; });
  return std::accumulate(rows.begin(), rows.end(), 0);
}

// A row may contain a loop of its own, and every loop is complete when it
// returns. The sum of 0..n-1 is n (n - 1) / 2.
TEST(ParallelRows, MayBeNested) {
  std::vector<int> sums(20);

  for (int loop = 0; loop < 50; ++loop) {
    parallel_rows(20, 2, [&](int row) {
      sums[static_cast<std::size_t>(row)] = sum_of_rows(30, 3);
    });

    EXPECT_EQ(std::count(sums.begin(), sums.end(), 30 * 29 / 2), 20);
  }
}

// Callers on several threads do not disturb each other.
TEST(ParallelRows, ServesSeveralCallers) {
  std::atomic<int> right = 0;
  {
    std::vector<std::jthread> callers;
    for (int caller = 0; caller < 4; ++caller)
      callers.emplace_back([&] {
        for (int loop = 0; loop < 200; ++loop)
          right += sum_of_rows(40, 3) == 40 * 39 / 2 ? 1 : 0;
      });
  }

  EXPECT_EQ(right, 4 * 200);
}

/// Rows that each wait until all threads have one; then the row on the chosen
/// thread throws, the caller's (0) or one of the helpers.
std::string message_from(int threads, int thrower) {
  std::atomic<int> begun = 0;
  try {
    parallel_turns(threads, threads, [&](int, int worker) {
      ++begun;
      while (begun < threads)
        std::this_thread::yield();
      if (worker == thrower)
        throw std::runtime_error("worker " + std::to_string(worker));
    });
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing thrown";
}

// An exception on any thread reaches the caller, after all threads have ended,
// and the helpers serve the next loop.
TEST(ParallelRows, RethrowsTheExceptionOfAnyThread) {
  for (const int threads : {1, 2, 3, 5})
    for (int thrower = 0; thrower < threads; ++thrower) {
      EXPECT_EQ(message_from(threads, thrower),
                "worker " + std::to_string(thrower))
          << threads;
      EXPECT_EQ(sum_of_rows(40, threads), 40 * 39 / 2);
    }
}

// Where every thread throws, one of the exceptions reaches the caller; where a
// nested loop throws, its exception passes through both.
TEST(ParallelRows, ThrowsOnceWhereAllThrow) {
  for (int loop = 0; loop < 100; ++loop) {
    EXPECT_THROW(
        parallel_rows(8, 3, [](int) { throw std::domain_error("each row"); }),
        std::domain_error);
    EXPECT_THROW(parallel_rows(4, 2,
                               [](int) {
                                 parallel_rows(3, 2, [](int row) {
                                   if (row == 1)
                                     throw std::bad_alloc();
                                 });
                               }),
                 std::bad_alloc);
  }
  EXPECT_EQ(sum_of_rows(64, 3), 64 * 63 / 2);
}

// After an exception no further row is begun. A row takes 1 ms here, and half
// of all rows the time in which the other thread is notified.
TEST(ParallelRows, BeginsNoRowAfterAnException) {
  std::atomic<bool> is_thrown = false;
  std::atomic<int> done = 0;
  const auto do_row = [&](int row) {
    if (row == 0) {
      is_thrown = true;
      throw std::runtime_error("first row");
    }
    while (!is_thrown)
      std::this_thread::yield();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ++done;
  };

  EXPECT_THROW(parallel_rows(1000, 2, do_row), std::runtime_error);

  EXPECT_LT(done, 500);
}

// A child process has helpers of its own and ends: two rows that wait for each
// other need two threads there. The alarm of a child that hangs ends it after
// 10 s.
TEST(ParallelRows, WorksInAChildProcess) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "the thread sanitizer starts no thread after a fork";
#endif
  sum_of_rows(64, 3);

  const pid_t child = fork();
  if (child == 0) {
    alarm(10);
    std::atomic<int> done = 0;
    two_rows_together([&] { ++done; });
    std::exit(done == 2 ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);

  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

} // namespace asperity::parallel_rows_test
