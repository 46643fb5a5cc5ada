// Claims about base/cpu_clock.hpp.
#include "base/cpu_clock.hpp"

#include <gtest/gtest.h>

#include <ctime>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace asperity {
namespace {

constexpr double work = 0.2; // [s], not a whole number

double process_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void compute() {
  const double begin = process_time();
  while (process_time() - begin < work) {
  }
}

// Claim: with several threads it is the CPU time of the process, which the C
// library states as well. Tolerance: the time between the two readings.
TEST(CpuClock, MeasuresTheProcess) {
  const CpuClock clock(2);
  const double begin = process_time();

  std::thread(compute).join();

  EXPECT_NEAR(clock.seconds(), process_time() - begin, 0.02);
}

// Claim: with one thread the work of others is not counted. Tolerance: the time
// that it takes to start a thread and to wait for it.
TEST(CpuClock, MeasuresOneThread) {
  const CpuClock clock;

  std::thread(compute).join();
  EXPECT_LT(clock.seconds(), 0.02);

  compute();
  EXPECT_NEAR(clock.seconds(), work, 0.02);
}

// Claim: the time of a child that has ended is counted. Tolerance: the time
// that it takes to start a child; the kernel counts from its first instruction.
TEST(CpuClock, CountsChildren) {
  const CpuClock clock;

  const pid_t child = fork();
  if (child == 0) {
    compute();
    _exit(0);
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);

  EXPECT_NEAR(clock.seconds(), work, 0.02);
}

} // namespace
} // namespace asperity
