// Tests of MemoryBudget: jobs that run at the same time fit into the memory,
// and a job that is too large, or of unknown size, runs alone.
#include "run/sweeps/memory_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

namespace asperity::run::memory_budget_test {

/// Runs jobs of these sizes, each in its own thread, and returns the largest
/// number that ran at the same time.
int largest_number_beside(double total, const std::vector<double>& sizes) {
  MemoryBudget budget(total);
  std::mutex mutex;
  int running = 0;
  int largest = 0;
  {
    std::vector<std::jthread> threads;
    for (const double size : sizes)
      threads.emplace_back([&, size] {
        const MemoryBudget::Share share(budget, size);
        {
          const std::lock_guard lock(mutex);
          largest = std::max(largest, ++running);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        const std::lock_guard lock(mutex);
        --running;
      });
  }
  return largest;
}

TEST(MemoryBudget, RunsJobsThatFitAtTheSameTime) {
  EXPECT_LE(largest_number_beside(2.5, std::vector<double>(6, 1.0)), 2);
}

TEST(MemoryBudget, RunsAloneWhatIsTooLargeOrUnknown) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();

  EXPECT_EQ(largest_number_beside(1.0, {2.0, 2.0, unknown, unknown}), 1);
}

} // namespace asperity::run::memory_budget_test
