#pragma once

// CPU seconds: what a step cost, whatever else runs beside it.

#include <ctime>

namespace asperity::app {

class CpuClock {
public:
  /// @param n_threads  that the work measured may use: 1 counts the thread that
  ///                   asks, more the whole process
  explicit CpuClock(int n_threads = 1)
      : clock_(n_threads == 1 ? CLOCK_THREAD_CPUTIME_ID
                              : CLOCK_PROCESS_CPUTIME_ID),
        start_(now()) {}

  /// Since construction [s].
  double seconds() const { return now() - start_; }

private:
  double now() const {
    timespec time{};
    clock_gettime(clock_, &time);
    return static_cast<double>(time.tv_sec) +
           1e-9 * static_cast<double>(time.tv_nsec);
  }

  clockid_t clock_;
  double start_;
};

} // namespace asperity::app
