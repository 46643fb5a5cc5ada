#pragma once

// Measures CPU time, which does not depend on other processes on the same
// machine.

#include <ctime>
#include <sys/resource.h>

namespace asperity {

class CpuClock {
public:
  /// @param n_threads  number that the measured work may use: 1 measures the
  ///                   calling thread, more the whole process
  explicit CpuClock(int n_threads = 1)
      : clock_(n_threads == 1 ? CLOCK_THREAD_CPUTIME_ID
                              : CLOCK_PROCESS_CPUTIME_ID),
        start_(now()) {}

  /// CPU time since construction [s], including child processes that have
  /// ended.
  double seconds() const { return now() - start_; }

private:
  double now() const {
    timespec time{};
    clock_gettime(clock_, &time);
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    return static_cast<double>(time.tv_sec) +
           1e-9 * static_cast<double>(time.tv_nsec) +
           in_seconds(children.ru_utime) + in_seconds(children.ru_stime);
  }

  static double in_seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) +
           1e-6 * static_cast<double>(time.tv_usec);
  }

  clockid_t clock_;
  double start_;
};

} // namespace asperity
