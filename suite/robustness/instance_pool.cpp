#include "suite/robustness/instance_pool.hpp"

#include "base/child_process.hpp"
#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <poll.h>
#include <stdexcept>
#include <thread>
#include <unistd.h>
#include <vector>

namespace asperity::robustness {
namespace {

using Clock = std::chrono::steady_clock;

/// One forked process. It runs instances first, first + stride, ... and writes
/// one line for each.
struct Worker {
  std::optional<ChildProcess> child;
  std::size_t next = 0;        ///< place of the current instance
  std::string text;            ///< received data that do not yet form a line
  double seconds_before = 0.0; ///< CPU time used before this instance [s]
  double seconds_seen = 0.0;   ///< the same up to `since` [s]
  Clock::time_point since;     ///< when it was last seen to use CPU time
};

void write_all(int pipe, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t n = write(pipe, text.data() + written, text.size() - written);
    if (n <= 0)
      throw std::runtime_error(
          "the reports of the problem instances cannot be written");
    written += static_cast<std::size_t>(n);
  }
}

class Pool {
public:
  Pool(InstanceSequence& instances, const PoolSettings& settings,
       const TakeReport& take, const RunOne& run_one)
      : instances_(instances),
        settings_(settings),
        take_(take),
        run_one_(run_one),
        stride_(processes_of(settings)) {}

  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  void run() {
    for (std::size_t first = 0; first < stride_; ++first)
      start(workers_.emplace_back(), first);
    while (std::any_of(workers_.begin(), workers_.end(), is_running)) {
      if (settings_.is_interrupted != nullptr && settings_.is_interrupted()) {
        kill_all();
        return;
      }
      wait_and_read();
    }
  }

private:
  static bool is_running(const Worker& worker) {
    return worker.child.has_value();
  }

  static std::size_t processes_of(const PoolSettings& settings) {
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return static_cast<std::size_t>(
        std::max(1, settings.processes > 0 ? settings.processes : cores));
  }

  void start(Worker& worker, std::size_t first) {
    worker = Worker{};
    worker.next = first;
    if (instances_.at(first) == nullptr)
      return;
    worker.child = ChildProcess::forked([this, first](int pipe) {
      for (std::size_t place = first;
           const Instance* instance = instances_.at(place); place += stride_) {
        write_all(pipe, to_line(run_one_(*instance)) + "\n");
        instances_.release_before(place);
      }
    });
    worker.since = Clock::now();
  }

  /// The children hold the interrupt only as a flag, so they are not asked.
  void kill_all() {
    for (Worker& worker : workers_)
      if (worker.child)
        worker.child->kill();
  }

  void wait_and_read() {
    std::vector<pollfd> waiting;
    for (const Worker& worker : workers_)
      waiting.push_back(
          {is_running(worker) ? worker.child->output_pipe() : -1, POLLIN, 0});
    poll(waiting.data(), waiting.size(), 100);
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      Worker& worker = workers_[i];
      if (!is_running(worker))
        continue;
      if ((waiting[i].revents & (POLLIN | POLLHUP)) != 0)
        read_from(worker);
      else if (const std::string reason = overdue(worker); !reason.empty())
        report_and_restart(worker, Outcome::timed_out, reason);
    }
  }

  /// Returns why an instance is ended, or "". The CPU time decides, so that a
  /// busy machine does not fail one; a process that waits for ever uses none.
  std::string overdue(Worker& worker) const {
    constexpr double progress = 0.01; // [s]
    constexpr double wall_time_factor = 10.0;
    const double used = worker.child->cpu_time();
    if (used > worker.seconds_seen + progress) {
      worker.seconds_seen = used;
      worker.since = Clock::now();
    }
    const double waited =
        std::chrono::duration<double>(Clock::now() - worker.since).count();
    const double limit = settings_.instance_seconds;
    if (used - worker.seconds_before > limit)
      return fmt::format("more than {:g} s of CPU time", limit);
    return waited > wall_time_factor * limit
               ? fmt::format("no CPU time for {:g} s", wall_time_factor * limit)
               : "";
  }

  void read_from(Worker& worker) {
    char buffer[65536];
    const ssize_t n = read(worker.child->output_pipe(), buffer, sizeof buffer);
    if (n <= 0) {
      finish(worker);
      return;
    }
    worker.text.append(buffer, static_cast<std::size_t>(n));
    for (std::size_t end_of_line = worker.text.find('\n');
         end_of_line != std::string::npos;
         end_of_line = worker.text.find('\n')) {
      take_(*instances_.at(worker.next),
            from_line(worker.text.substr(0, end_of_line)));
      worker.text.erase(0, end_of_line + 1);
      worker.next += stride_;
      worker.since = Clock::now();
      worker.seconds_before = worker.child->cpu_time();
    }
  }

  /// Handles a closed pipe: the process has finished, or it died at an
  /// instance.
  void finish(Worker& worker) {
    if (instances_.at(worker.next) != nullptr)
      report_and_restart(worker, Outcome::crashed,
                         worker.child->wait().failure);
    else
      worker.child.reset();
  }

  void report_and_restart(Worker& worker, Outcome outcome,
                          const std::string& reason) {
    const Instance& instance = *instances_.at(worker.next);
    InstanceReport report;
    report.index = instance.index;
    report.outcome = outcome;
    report.reason = reason;
    take_(instance, report);
    worker.child->kill(); // a hanging process does not respond to requests
    start(worker, worker.next + stride_);
  }

  InstanceSequence& instances_;
  const PoolSettings& settings_;
  const TakeReport& take_;
  const RunOne& run_one_;
  std::size_t stride_;
  std::vector<Worker> workers_;
};

} // namespace

void run_instances(InstanceSequence& instances, const PoolSettings& settings,
                   const TakeReport& take, const RunOne& run_one) {
  require_positive("instance_seconds", settings.instance_seconds, "s");
  Pool(instances, settings, take, run_one).run();
}

} // namespace asperity::robustness
