#include "stress/scene_pool.hpp"

#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <ctime>
#include <poll.h>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace asperity::stress {
namespace {

using Clock = std::chrono::steady_clock;

/// One forked process: it runs scenes first, first + stride, ... and writes a
/// line for each.
struct Child {
  pid_t process = -1;
  int pipe = -1;
  std::size_t next = 0; ///< the scene it is at
  std::string text;     ///< received, not yet a line
  Clock::time_point since;
  double seconds_before = 0.0; ///< of CPU time, up to this scene
};

/// CPU time of a process [s]; a crowded machine is no fault of a scene.
double cpu_seconds(pid_t process) {
  clockid_t clock{};
  timespec time{};
  if (clock_getcpuclockid(process, &clock) != 0 ||
      clock_gettime(clock, &time) != 0)
    return 0.0;
  return static_cast<double>(time.tv_sec) +
         1e-9 * static_cast<double>(time.tv_nsec);
}

void write_all(int pipe, const std::string& text) {
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t n = write(pipe, text.data() + written, text.size() - written);
    if (n <= 0)
      _exit(1);
    written += static_cast<std::size_t>(n);
  }
}

class Pool {
public:
  Pool(std::span<const Scene> scenes, const PoolSettings& settings,
       const std::function<void(const SceneReport&)>& take,
       const RunOne& run_one)
      : scenes_(scenes),
        settings_(settings),
        take_(take),
        run_one_(run_one),
        stride_(std::min(scenes.size(), processes_of(settings))) {}

  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// Whatever ends this process early ends the children it started.
  ~Pool() {
    for (Child& child : children_)
      end(child, true);
  }

  void run() {
    for (std::size_t first = 0; first < stride_; ++first)
      start(children_.emplace_back(), first);
    while (std::any_of(children_.begin(), children_.end(), is_running))
      wait_and_read();
  }

private:
  static bool is_running(const Child& child) { return child.process > 0; }

  static std::size_t processes_of(const PoolSettings& settings) {
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    return static_cast<std::size_t>(
        std::max(1, settings.processes > 0 ? settings.processes : cores));
  }

  void start(Child& child, std::size_t first) {
    child = Child{};
    child.next = first;
    if (first >= scenes_.size())
      return;
    int ends[2];
    if (pipe(ends) != 0)
      throw std::runtime_error("stress: no pipe to a child process");
    child.process = fork();
    if (child.process < 0)
      throw std::runtime_error("stress: no child process could be started");
    if (child.process == 0) {
      close(ends[0]);
      for (std::size_t i = first; i < scenes_.size(); i += stride_)
        write_all(ends[1], to_line(run_one_(scenes_[i])) + "\n");
      _exit(0); // no destructors of the parent's
    }
    close(ends[1]);
    child.pipe = ends[0];
    child.since = Clock::now();
  }

  /// Its exit status; killed first if it must be.
  static int end(Child& child, bool is_to_kill) {
    if (child.process <= 0)
      return 0;
    if (is_to_kill)
      kill(child.process, SIGKILL);
    int status = 0;
    waitpid(child.process, &status, 0);
    close(child.pipe);
    child.process = -1;
    return status;
  }

  void wait_and_read() {
    std::vector<pollfd> waiting;
    for (const Child& child : children_)
      waiting.push_back({is_running(child) ? child.pipe : -1, POLLIN, 0});
    poll(waiting.data(), waiting.size(), 100);
    for (std::size_t i = 0; i < children_.size(); ++i) {
      Child& child = children_[i];
      if (!is_running(child))
        continue;
      if ((waiting[i].revents & (POLLIN | POLLHUP)) != 0)
        read_from(child);
      else if (is_overdue(child))
        give_up(child, Outcome::timed_out,
                fmt::format("longer than {:g} s of CPU time",
                            settings_.scene_seconds));
    }
  }

  bool is_overdue(const Child& child) const {
    constexpr double patience = 10.0; // a process that waits uses no time
    const double waited =
        std::chrono::duration<double>(Clock::now() - child.since).count();
    return cpu_seconds(child.process) - child.seconds_before >
               settings_.scene_seconds ||
           waited > patience * settings_.scene_seconds;
  }

  void read_from(Child& child) {
    char buffer[65536];
    const ssize_t n = read(child.pipe, buffer, sizeof buffer);
    if (n <= 0) {
      finish(child);
      return;
    }
    child.text.append(buffer, static_cast<std::size_t>(n));
    for (std::size_t end_of_line = child.text.find('\n');
         end_of_line != std::string::npos;
         end_of_line = child.text.find('\n')) {
      take_(from_line(child.text.substr(0, end_of_line)));
      child.text.erase(0, end_of_line + 1);
      child.next += stride_;
      child.since = Clock::now();
      child.seconds_before = cpu_seconds(child.process);
    }
  }

  /// Its pipe is closed: it is through, or it died at a scene.
  void finish(Child& child) {
    const int status = end(child, false);
    if (child.next < scenes_.size())
      report_and_restart(
          child, Outcome::crashed,
          WIFSIGNALED(status)
              ? fmt::format("signal {}", WTERMSIG(status))
              : fmt::format("exit code {}", WEXITSTATUS(status)));
  }

  void give_up(Child& child, Outcome outcome, const std::string& reason) {
    end(child, true);
    report_and_restart(child, outcome, reason);
  }

  void report_and_restart(Child& child, Outcome outcome,
                          const std::string& reason) {
    SceneReport report;
    report.index = scenes_[child.next].index;
    report.outcome = outcome;
    report.reason = reason;
    take_(report);
    start(child, child.next + stride_);
  }

  std::span<const Scene> scenes_;
  const PoolSettings& settings_;
  const std::function<void(const SceneReport&)>& take_;
  const RunOne& run_one_;
  std::size_t stride_;
  std::vector<Child> children_;
};

} // namespace

void run_scenes(std::span<const Scene> scenes, const PoolSettings& settings,
                const std::function<void(const SceneReport&)>& take,
                const RunOne& run_one) {
  require_positive("scene_seconds", settings.scene_seconds, "s");
  if (!scenes.empty())
    Pool(scenes, settings, take, run_one).run();
}

} // namespace asperity::stress
