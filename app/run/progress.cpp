#include "app/run/progress.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace asperity::app {
namespace {

constexpr int bar_width = 24;
constexpr std::chrono::milliseconds shortest_pause{200};

} // namespace

Progress::Progress(int n_steps, double contact_modulus)
    : n_steps_(std::max(n_steps, 1)),
      contact_modulus_(contact_modulus),
      is_terminal_(isatty(STDOUT_FILENO) == 1),
      start_(Clock::now()) {}

Progress::~Progress() {
  if (is_terminal_)
    fmt::print("\r\033[K");
}

void Progress::step_done(const std::string& method, int realization,
                         const results::CurvePoint& point, double rms_height) {
  const std::lock_guard lock(mutex_);
  ++n_done_;
  const bool has_failed = point.status == results::StepStatus::not_converged;
  if (is_terminal_ && !has_failed) {
    draw_bar(method, realization, point);
    return;
  }
  fmt::print("{}{:>4}/{} {:<14} realization {} step {:>2}  p0 = {:.4e} E*  "
             "u = {:+.4f} h_rms  A = {:6.3f} %  {:>3} it  residual {:.1e}  "
             "{:.2f} s{}{}\n",
             is_terminal_ ? "\r\033[K" : "", n_done_, n_steps_, method,
             realization, point.step, point.nominal_pressure / contact_modulus_,
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
  n_done_ += n_steps;
  fmt::print("{}{:>4}/{} {:<14} realization {} {} steps from the cache\n",
             is_terminal_ ? "\r\033[K" : "", n_done_, n_steps_, method,
             realization, n_steps);
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

void Progress::draw_head() const {
  const int filled = bar_width * n_done_ / n_steps_;
  fmt::print("\r\033[K[{:#<{}}{:.<{}}] {}/{}", "", filled, "",
             bar_width - filled, n_done_, n_steps_);
}

void Progress::draw_bar(const std::string& method, int realization,
                        const results::CurvePoint& point) {
  const auto left = std::chrono::duration_cast<std::chrono::seconds>(
      (Clock::now() - start_) * (n_steps_ - n_done_) / n_done_);
  draw_head();
  fmt::print("  {} r{} step {}  residual {:.0e}  {:%H:%M:%S} left", method,
             realization, point.step, point.residual, left);
  std::fflush(stdout);
}

} // namespace asperity::app
