#include "run/remaining_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::run {
namespace {

/// Share of the work from which on the finished steps tell more than the
/// prediction. Cheap steps at the beginning would scale the cost of dear ones
/// by their overhead.
constexpr double least_share = 0.02;

/// Part of a step from which on its residual tells more than the prediction.
constexpr double least_share_of_step = 0.1;

} // namespace

double share_done(double residual, double tolerance) {
  if (!(residual > 0.0 && residual < 1.0 && tolerance > 0.0 && tolerance < 1.0))
    return 0.0;
  return std::min(1.0, std::log(residual) / std::log(tolerance));
}

RemainingWork::RemainingWork(const std::map<std::string, MethodWork>& methods,
                             double wall_per_cpu)
    : wall_per_cpu_(wall_per_cpu) {
  bool is_predicted = true;
  for (const auto& [name, work] : methods) {
    n_steps_ += work.steps;
    is_predicted = is_predicted && std::isfinite(work.step_time);
    weights_[name] = work.step_time;
    total_ += work.steps * work.step_time;
  }
  if (is_predicted && total_ > 0.0)
    return;
  for (auto& [name, weight] : weights_) // count steps instead
    weight = 1.0;
  total_ = n_steps_;
}

double RemainingWork::weight(const std::string& method) const {
  const auto found = weights_.find(method);
  return found == weights_.end() ? 0.0 : found->second;
}

void RemainingWork::add_done(const std::string& method, int n_steps) {
  n_done_ += n_steps;
  done_ += n_steps * weight(method);
}

void RemainingWork::add_kept(const std::string& method, int n_steps) {
  n_done_ += n_steps;
  total_ -= n_steps * weight(method);
}

std::optional<double>
RemainingWork::seconds_left(double elapsed, double since_last,
                            const StepAtWork& step) const {
  const double left = std::max(total_ - done_, 0.0);
  if (left == 0.0)
    return 0.0;
  const bool is_measured = done_ > 0.0 && done_ >= least_share * total_;
  const double speed =
      is_measured ? (elapsed - since_last) / done_ : wall_per_cpu_;
  const double predicted = speed * left - (done_ > 0.0 ? since_last : elapsed);
  const double after = std::max(left - weight(step.method), 0.0);
  const double observed =
      step.share >= least_share_of_step
          ? step.elapsed * (1.0 / step.share - 1.0) + speed * after
          : 0.0;
  const double seconds = std::max(predicted, observed);
  return seconds > 0.0 ? std::optional<double>(seconds) : std::nullopt;
}

std::string duration_text(double seconds) {
  if (seconds < 99.5)
    return fmt::format("{:.0f} s", seconds);
  return seconds < 99.5 * 60.0 ? fmt::format("{:.0f} min", seconds / 60.0)
                               : fmt::format("{:.1f} h", seconds / 3600.0);
}

std::string remaining_text(const std::optional<double>& seconds) {
  return seconds ? "about " + duration_text(*seconds) + " left"
                 : "longer than predicted";
}

} // namespace asperity::run
