#include "run/progress.hpp"

#include "base/shown_number.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace asperity::run {
namespace {

constexpr int widest_bar = 24;
constexpr int usual_columns = 80; // of a terminal that does not tell
constexpr std::chrono::milliseconds shortest_pause{200};
constexpr std::chrono::milliseconds redraw_pause{1000};

/// Part of a step from which on its residual tells how long it takes.
constexpr double least_share_of_step = 0.1;

double seconds_between(std::chrono::steady_clock::time_point from,
                       std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// Columns of the terminal, which can change at any time.
int terminal_columns() {
  winsize size{};
  const bool is_known =
      ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : usual_columns;
}

} // namespace

std::string time_text(double seconds) {
  if (seconds < 59.5)
    return fmt::format("{:.2g} s", seconds);
  return seconds < 59.5 * 60.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                               : fmt::format("{:.3g} h", seconds / 3600.0);
}

std::string remaining_text(const std::optional<double>& seconds) {
  return seconds ? "about " + time_text(*seconds) + " left"
                 : "time left unknown";
}

std::string remaining_text(std::chrono::steady_clock::time_point begin,
                           std::size_t done, std::size_t all) {
  constexpr double least = 10.0; // [s]
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  return done >= all || elapsed < least
             ? ""
             : remaining_text(elapsed / static_cast<double>(done) *
                              static_cast<double>(all - done));
}

double share_done(double residual, double tolerance) {
  if (!(residual > 0.0 && residual < 1.0 && tolerance > 0.0 && tolerance < 1.0))
    return 0.0;
  return std::min(1.0, std::log(residual) / std::log(tolerance));
}

RemainingWork::RemainingWork(const std::map<std::string, int>& steps) {
  for (const auto& [method, n_steps] : steps) {
    methods_[method].left = n_steps;
    n_steps_ += n_steps;
  }
}

void RemainingWork::add_done(const std::string& method, double cpu_time) {
  MethodWork& work = methods_[method];
  --work.left;
  ++work.done;
  ++n_done_;
  work.cpu_time += cpu_time;
}

void RemainingWork::add_kept(const std::string& method, int n_steps) {
  methods_[method].left -= n_steps;
  n_done_ += n_steps;
}

double RemainingWork::mean_cost(const MethodWork& work) const {
  if (work.done > 0)
    return work.cpu_time / work.done;
  double dearest = 0.0;
  for (const auto& [name, other] : methods_)
    if (other.done > 0)
      dearest = std::max(dearest, other.cpu_time / other.done);
  return dearest;
}

std::optional<double>
RemainingWork::seconds_left(double elapsed, double since_last,
                            const StepAtWork& step) const {
  const int n_left = n_steps_ - n_done_;
  if (n_left <= 0)
    return 0.0;
  double done = 0.0; // CPU times
  double left = 0.0;
  for (const auto& [name, work] : methods_) {
    done += work.cpu_time;
    left += work.left * mean_cost(work);
  }
  const double speed = done > 0.0 ? (elapsed - since_last) / done : 0.0;
  double seconds = speed * left - since_last;
  if (step.share >= least_share_of_step) {
    const double whole = step.elapsed / step.share;
    const auto of_step = methods_.find(step.method);
    const double others =
        done > 0.0 && of_step != methods_.end()
            ? speed * std::max(left - mean_cost(of_step->second), 0.0)
            : (n_left - 1) * whole;
    seconds = std::max(seconds, whole - step.elapsed + others);
  }
  return seconds > 0.0 ? std::optional<double>(seconds) : std::nullopt;
}

std::string bar_line(int done, int steps, const std::string& words,
                     int columns) {
  const int width = columns < 100 ? widest_bar / 2 : widest_bar;
  const int filled = std::clamp(width * done / std::max(steps, 1), 0, width);
  const std::string line = fmt::format("[{:#<{}}{:.<{}}] {}/{}  {}", "", filled,
                                       "", width - filled, done, steps, words);
  // A line that reaches the last column would be continued in the next one,
  // and could not be drawn over.
  return line.substr(0, static_cast<std::size_t>(std::max(columns - 1, 0)));
}

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
  end();
}

void Progress::end() {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(is_ended_, true))
      return;
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
  progress_.running_[id_] = {.what = what, .since = Clock::now()};
}

Progress::Activity::~Activity() {
  const std::lock_guard lock(progress_.mutex_);
  progress_.running_.erase(id_);
}

void Progress::step_done(const std::string& method, int realization,
                         const results::CurvePoint& point, double rms_height) {
  const std::lock_guard lock(mutex_);
  work_.add_done(method, point.cpu_time);
  last_done_ = last_drawn_ = Clock::now();
  const bool has_failed = point.status == results::StepStatus::not_converged;
  if (is_terminal_ && !has_failed) {
    draw_bar(fmt::format("{}  {} r{} step {}  residual {:.0e}",
                         remaining(Clock::now()), method, realization,
                         point.step, point.residual));
    return;
  }
  fmt::print("{}{:>4}/{} {:<14} realization {} step {:>2}  p0 = {:.4e} E*  "
             "u = {:+.4f} h_rms  A = {:6.3f} %  {:>3} it  residual {:.1e}  "
             "{:.2f} s{}{}\n",
             is_terminal_ ? "\r\033[K" : "", work_.steps_done(), work_.steps(),
             method, realization, point.step,
             point.nominal_pressure / contact_modulus_,
             Shown{point.mean_gap / rms_height}, 100.0 * point.area_fraction,
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

std::string Progress::job_text(const std::string& method, int realization) {
  return fmt::format("{}, realization {}, ", method, realization);
}

void Progress::at_work(const std::string& method, int realization,
                       const std::string& words, double share) {
  const std::lock_guard lock(mutex_);
  const std::string job = job_text(method, realization);
  const auto found = std::ranges::find_if(running_, [&](const auto& entry) {
    return entry.second.what.starts_with(job);
  });
  if (found == running_.end())
    return;
  Running& running = found->second;
  running.method = method;
  running.brief = fmt::format("{} r{}", method, realization);
  running.words = words;
  running.share = share;
  const auto now = Clock::now();
  if (!is_terminal_ || now - last_drawn_ < shortest_pause)
    return;
  last_drawn_ = now;
  draw_bar(brief_text(running, now));
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
    const Running* const activity = longest_activity();
    if (!activity)
      continue;
    if (is_terminal_) {
      draw_bar(brief_text(*activity, now));
      continue;
    }
    fmt::print("  {}: at work for {}; {}{}{}; {} of {} steps done\n",
               activity->what, time_text(seconds_between(activity->since, now)),
               activity->words, activity->words.empty() ? "" : "; ",
               remaining(now), work_.steps_done(), work_.steps());
    std::fflush(stdout);
  }
}

const Progress::Running* Progress::longest_activity() const {
  const auto longest = std::min_element(
      running_.begin(), running_.end(), [](const auto& one, const auto& other) {
        return one.second.since < other.second.since;
      });
  return longest == running_.end() ? nullptr : &longest->second;
}

std::string Progress::brief_text(const Running& running,
                                 Clock::time_point now) const {
  return remaining(now) + "  " +
         (running.words.empty()
              ? running.what + ": at work for " +
                    time_text(seconds_between(running.since, now))
              : running.brief + "  " + running.words);
}

std::string Progress::remaining(Clock::time_point now) const {
  StepAtWork step;
  if (const Running* const activity = longest_activity())
    step = {activity->method, seconds_between(activity->since, now),
            activity->share};
  return remaining_text(work_.seconds_left(
      seconds_between(start_, now), seconds_between(last_done_, now), step));
}

void Progress::draw_bar(const std::string& words) const {
  fmt::print("\r\033[K{}", bar_line(work_.steps_done(), work_.steps(), words,
                                    terminal_columns()));
  std::fflush(stdout);
}

} // namespace asperity::run
