#pragma once

// Runs jobs in parallel on the cores of the machine.

#include <functional>
#include <span>

namespace asperity::methods {

class WorkerPool {
public:
  using Job = std::function<void()>;

  /// @param threads  0: all hardware threads
  explicit WorkerPool(int threads);

  int threads() const { return threads_; }

  /// Returns the number of threads that each job of the last run() may use: all
  /// of them for a single job, otherwise one.
  int threads_per_job() const { return threads_a_job_; }

  /// Runs all jobs, in their order as workers become free, and waits for them.
  ///
  /// @throws the exception of the first job that failed, after the running jobs
  /// have ended; the remaining jobs are not started
  void run(std::span<const Job> jobs);

private:
  int threads_;
  int threads_a_job_ = 1;
};

} // namespace asperity::methods
