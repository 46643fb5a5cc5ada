// Tests of base/cpu_clock.hpp. Each time is enclosed by two readings of the
// kernel's own account, so that a busy machine cannot make a test fail.
#include "base/cpu_clock.hpp"

#include <gtest/gtest.h>

#include <ctime>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace asperity::cpu_clock_test {

constexpr double work = 0.2;  // [s], not a whole number
constexpr double tick = 0.02; // [s], two periods of the kernel's slowest clock

double time_of(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(time.tv_nsec);
}

double process_time() {
  return time_of(CLOCK_PROCESS_CPUTIME_ID);
}

double thread_time() {
  return time_of(CLOCK_THREAD_CPUTIME_ID);
}

/// Works for `work` seconds and returns the CPU time of the calling thread.
double compute() {
  const double begin = process_time();
  while (process_time() - begin < work) {
  }
  return thread_time();
}

// With several threads it is the CPU time of the process.
TEST(CpuClock, MeasuresTheProcess) {
  const double before = process_time();
  const CpuClock clock(2);

  std::thread(compute).join();
  const double measured = clock.seconds();

  EXPECT_GE(measured, work - tick);
  EXPECT_LE(measured, process_time() - before + tick);
}

// With one thread the work of other threads is not counted.
TEST(CpuClock, MeasuresOneThread) {
  const double process_before = process_time();
  const CpuClock clock;

  double of_other = 0;
  std::thread([&of_other] { of_other = compute(); }).join();
  const double beside_other = clock.seconds();
  EXPECT_LE(beside_other, process_time() - process_before - of_other + tick);

  const double before = thread_time();
  compute();
  const double after = thread_time();
  EXPECT_GE(clock.seconds() - beside_other, after - before - tick);
  EXPECT_LE(clock.seconds(), thread_time() + tick);
}

// The time of a child that has ended is counted, as the kernel states it for
// this child.
TEST(CpuClock, CountsChildren) {
  const double before = thread_time();
  const CpuClock clock;

  const pid_t child = fork();
  if (child == 0) {
    compute();
    _exit(0);
  }
  rusage of_child{};
  ASSERT_EQ(wait4(child, nullptr, 0, &of_child), child);
  const double measured = clock.seconds();

  const auto in_seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) +
           1e-6 * static_cast<double>(time.tv_usec);
  };
  const double child_time =
      in_seconds(of_child.ru_utime) + in_seconds(of_child.ru_stime);
  EXPECT_GE(child_time, work - tick);
  EXPECT_GE(measured, child_time - tick);
  EXPECT_LE(measured, child_time + thread_time() - before + tick);
}

} // namespace asperity::cpu_clock_test
