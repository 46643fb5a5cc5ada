#pragma once

// Jobs side by side on the machine's cores.

#include <functional>
#include <span>

namespace asperity::app {

class WorkerPool {
public:
  using Job = std::function<void()>;

  /// @param threads  0: as many as the machine has
  explicit WorkerPool(int threads);

  int threads() const { return threads_; }

  /// How many threads a job of the last run() may use itself: all of them if
  /// it was alone, else one.
  int threads_a_job() const { return threads_a_job_; }

  /// Runs all, in their order as workers become free, and waits.
  /// @throws what the first failing job threw, after the running ones ended;
  ///         the others are not begun
  void run(std::span<const Job> jobs);

private:
  int threads_;
  int threads_a_job_ = 1;
};

} // namespace asperity::app
