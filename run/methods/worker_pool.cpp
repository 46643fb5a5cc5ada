#include "run/methods/worker_pool.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace asperity::methods {

WorkerPool::WorkerPool(int threads)
    : threads_(threads > 0
                   ? threads
                   : std::max(1, static_cast<int>(
                                     std::thread::hardware_concurrency()))) {}

void WorkerPool::run(std::span<const Job> jobs) {
  const int n_jobs = static_cast<int>(jobs.size());
  const int n_workers = std::max(1, std::min(threads_, n_jobs));
  threads_a_job_ = n_jobs == 1 ? threads_ : 1;
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto work = [&] {
    for (std::size_t job = next++; job < jobs.size(); job = next++) {
      try {
        jobs[job]();
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure)
          failure = std::current_exception();
        next = jobs.size();
      }
    }
  };
  {
    std::vector<std::jthread> workers;
    for (int worker = 1; worker < n_workers; ++worker)
      workers.emplace_back(work);
    work();
  }
  if (failure)
    std::rethrow_exception(failure);
}

} // namespace asperity::methods
