#include "app/run/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace asperity::app {
namespace {

constexpr int bar_width = 24;
constexpr std::chrono::milliseconds shortest_pause{200};
constexpr std::chrono::milliseconds redraw_pause{1000};

double seconds_between(std::chrono::steady_clock::time_point from,
                       std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

} // namespace

Progress::Progress(RemainingWork work, double contact_modulus,
                   std::chrono::milliseconds silence)
    : work_(std::move(work)),
      contact_modulus_(contact_modulus),
      is_terminal_(isatty(STDOUT_FILENO) == 1),
      silence_(silence),
      start_(Clock::now()),
      last_done_(start_),
      last_drawn_(start_),
      watcher_([this] { watch(); }) {}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    is_ended_ = true;
  }
  ended_.notify_all();
  watcher_.join();
  if (is_terminal_)
    fmt::print("\r\033[K");
}

Progress::Activity::Activity(Progress& progress, const std::string& what)
    : progress_(progress) {
  const std::lock_guard lock(progress_.mutex_);
  id_ = progress_.next_id_++;
  progress_.running_[id_] = {what, Clock::now()};
}

Progress::Activity::~Activity() {
  const std::lock_guard lock(progress_.mutex_);
  progress_.running_.erase(id_);
}

void Progress::step_done(const std::string& method, int realization,
                         const results::CurvePoint& point, double rms_height) {
  const std::lock_guard lock(mutex_);
  work_.add_done(method, 1);
  last_done_ = last_drawn_ = Clock::now();
  const bool has_failed = point.status == results::StepStatus::not_converged;
  if (is_terminal_ && !has_failed) {
    draw_bar(method, realization, point);
    return;
  }
  fmt::print("{}{:>4}/{} {:<14} realization {} step {:>2}  p0 = {:.4e} E*  "
             "u = {:+.4f} h_rms  A = {:6.3f} %  {:>3} it  residual {:.1e}  "
             "{:.2f} s{}{}\n",
             is_terminal_ ? "\r\033[K" : "", work_.steps_done(), work_.steps(),
             method, realization, point.step,
             point.nominal_pressure / contact_modulus_,
             point.mean_gap / rms_height, 100.0 * point.area_fraction,
             point.iterations, point.residual, point.cpu_time,
             has_failed           ? "  NOT CONVERGED: "
             : point.note.empty() ? ""
                                  : "  ",
             point.note);
  std::fflush(stdout);
}

void Progress::steps_kept(const std::string& method, int realization,
                          int n_steps) {
  const std::lock_guard lock(mutex_);
  work_.add_kept(method, n_steps);
  fmt::print("{}{:>4}/{} {:<14} realization {} {} steps from the cache\n",
             is_terminal_ ? "\r\033[K" : "", work_.steps_done(), work_.steps(),
             method, realization, n_steps);
  std::fflush(stdout);
}

void Progress::at_work(const std::string& method, int realization,
                       int evaluations, double energy, double residual) {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (!is_terminal_ || now - last_drawn_ < shortest_pause)
    return;
  last_drawn_ = now;
  draw_head();
  fmt::print("  {} r{}  {} evaluations  energy {:.6e} J  residual {:.1e}",
             method, realization, evaluations, energy, residual);
  std::fflush(stdout);
}

void Progress::watch() {
  const auto pause = is_terminal_ ? redraw_pause : silence_;
  std::unique_lock lock(mutex_);
  while (!ended_.wait_until(lock, last_drawn_ + pause,
                            [this] { return is_ended_; })) {
    const auto now = Clock::now();
    if (now - last_drawn_ < pause) // a line was printed meanwhile
      continue;
    last_drawn_ = now;
    const std::string activity = longest_activity(now);
    if (activity.empty())
      continue;
    if (is_terminal_)
      draw_head();
    fmt::print("  {}; {}{}", activity, remaining(now),
               is_terminal_ ? ""
                            : fmt::format("; {} of {} steps done\n",
                                          work_.steps_done(), work_.steps()));
    std::fflush(stdout);
  }
}

std::string Progress::longest_activity(Clock::time_point now) const {
  const auto longest = std::min_element(
      running_.begin(), running_.end(), [](const auto& one, const auto& other) {
        return one.second.since < other.second.since;
      });
  if (longest == running_.end())
    return "";
  return longest->second.what + ": at work for " +
         duration_text(seconds_between(longest->second.since, now));
}

std::string Progress::remaining(Clock::time_point now) const {
  return remaining_text(work_.seconds_left(seconds_between(start_, now),
                                           seconds_between(last_done_, now)));
}

void Progress::draw_head() const {
  const int n_steps = std::max(work_.steps(), 1);
  const int filled =
      std::min(bar_width * work_.steps_done() / n_steps, bar_width);
  fmt::print("\r\033[K[{:#<{}}{:.<{}}] {}/{}", "", filled, "",
             bar_width - filled, work_.steps_done(), work_.steps());
}

void Progress::draw_bar(const std::string& method, int realization,
                        const results::CurvePoint& point) {
  draw_head();
  fmt::print("  {} r{} step {}  residual {:.0e}  {}", method, realization,
             point.step, point.residual, remaining(Clock::now()));
  std::fflush(stdout);
}

} // namespace asperity::app
