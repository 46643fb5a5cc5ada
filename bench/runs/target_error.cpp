#include "bench/runs/target_error.hpp"

#include "bench/analysis/bench_answer.hpp"
#include "bench/settings/bench_axes.hpp"
#include "bench/settings/bench_plan.hpp"
#include "bench/settings/block_settings.hpp"
#include "bench/settings/case_values.hpp"
#include "cases/reader/vocabulary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity::bench {
namespace {

constexpr int least_target_points = 32;
constexpr int most_points = 4096;
constexpr std::array growth_shares{1.0, 0.5, 0.25};

std::vector<std::string> elements_of(const cases::Case& contact_case,
                                     const std::string& method) {
  for (const Axis& axis : axes_of(CaseValues(contact_case), method))
    if (axis.key == "element") {
      std::vector<std::string> words;
      for (const AxisValue& value : axis.values)
        words.push_back(value.text);
      return words;
    }
  return {""};
}

/// Returns the grading ratio of the layers; 1 if the method has none or the
/// layers are equal.
double growth_of(const cases::Case& contact_case, const std::string& method) {
  const auto growth = CaseValues(contact_case).value(method, "growth");
  return growth && growth->is_number() ? growth->number() : 1.0;
}

std::vector<std::string> overrides_at(const Forecast& forecast,
                                      double growth_share) {
  std::vector<std::string> overrides;
  if (!forecast.element.empty())
    overrides.push_back(
        fmt::format("{}.element={}", forecast.method, forecast.element));
  if (growth_share != 1.0 && forecast.growth > 1.0)
    overrides.push_back(fmt::format("{}.growth={:.6g}", forecast.method,
                                    std::pow(forecast.growth, growth_share)));
  return overrides;
}

} // namespace

TargetSearch::TargetSearch(const cases::Case& contact_case,
                           BenchRunnerOptions options)
    : case_(contact_case),
      runner_(contact_case, std::move(options)),
      quantities_(asked_quantities(contact_case)) {
  const int own = contact_case.surface.points.value_or(0);
  const int least = std::max(least_target_points,
                             least_carrying_points(contact_case.surface));
  int coarsest = own;
  while (coarsest % 4 == 0 && coarsest / 2 >= least && permits(coarsest / 2))
    coarsest /= 2;
  if (4 * least <= 3 * coarsest && permits(least)) // an intermediate grid
    coarsest = least;
  for (const int factor : {1, 2, 4})
    if (own > 0 && (factor <= 2 || factor * coarsest <= own))
      grids_.push_back(factor * coarsest);
}

/// Returns whether all methods accept so many points per side.
bool TargetSearch::permits(int points) const {
  return points % 2 == 0 &&
         std::ranges::all_of(case_.methods, [&](const auto& method) {
           return permits_points(case_, method, points);
         });
}

BenchPoint TargetSearch::run_at(const std::string& method,
                                const std::string& element, int points,
                                double growth_share,
                                const std::vector<std::string>& more) {
  BenchPoint point;
  point.method = method;
  point.kind = kind_of_method(method);
  point.points = points;
  point.is_reference = true; // one run is sufficient
  point.overrides = overrides_at({.method = method,
                                  .element = element,
                                  .growth = growth_of(case_, method)},
                                 growth_share);
  point.overrides.push_back(fmt::format("surface.points={}", points));
  point.overrides.insert(point.overrides.end(), more.begin(), more.end());
  runner_.run(point);
  search_cpu_time_ += point.problem.empty() ? point.cpu.median : 0.0;
  return point;
}

Forecast TargetSearch::forecast_of(const std::string& method,
                                   const std::string& element) {
  Forecast forecast{
      .method = method, .element = element, .growth = growth_of(case_, method)};
  std::vector<BenchPoint> coarse;
  std::vector<BenchAnswer> exact;
  for (const int points : grids_) {
    coarse.push_back(run_at(method, element, points, 1.0));
    if (!coarse.back().problem.empty()) {
      problem_ = fmt::format("{} on {} points per side: {}", method, points,
                             coarse.back().problem);
      return forecast;
    }
    exact.push_back(exact_answer(case_, coarse.back().answer));
  }
  add_runs(forecast, coarse, quantities_);
  if (forecast.growth > 1.0)
    add_growth(forecast, coarse.front(),
               run_at(method, element, coarse.front().points, 0.5));
  add_exact(forecast, coarse, exact);
  return forecast;
}

void TargetSearch::make_forecasts() {
  for (const cases::MethodSpec& method : case_.methods)
    if (varies_with_points(kind_of_method(method.name)))
      for (const std::string& element : elements_of(case_, method.name))
        forecasts_.push_back(forecast_of(method.name, element));
}

int TargetSearch::finest_points() const {
  return std::max(std::min(4 * *case_.surface.points, most_points),
                  grids_.back());
}

bool TargetSearch::choose_at(int points, double growth_share, double target,
                             Choice& choice) {
  choice = {points, growth_share, 0.0, {}};
  for (Forecast& forecast : forecasts_) {
    const bool keeps = std::all_of(
        quantities_.begin(), quantities_.end(), [&](const auto& quantity) {
          return forecast.error(quantity, points, growth_share) < target;
        });
    if (!keeps)
      continue;
    Forecast*& best = choice.methods[forecast.method];
    if (best == nullptr || forecast.cpu_time(points) < best->cpu_time(points))
      best = &forecast;
  }
  for (const Forecast& forecast : forecasts_)
    if (!choice.methods.contains(forecast.method))
      return false;
  for (const auto& [method, forecast] : choice.methods)
    choice.cpu_time += forecast->cpu_time(points);
  return !choice.methods.empty();
}

bool TargetSearch::find_choice(double target) {
  const int last = finest_points();
  bool is_found = false;
  for (int base = grids_.front(); base <= last; base *= 2)
    for (const int points : {base, base + base / 2})
      for (const double growth_share : growth_shares) {
        Choice choice;
        if (permits(points) && points <= last &&
            choose_at(points, growth_share, target, choice) &&
            (!is_found || choice.cpu_time < choice_.cpu_time)) {
          choice_ = std::move(choice);
          is_found = true;
          break;
        }
      }
  return is_found;
}

void TargetSearch::add_checks(TargetOutcome& outcome) const {
  outcome.predicted_cpu_time = choice_.cpu_time;
  outcome.overrides = {fmt::format("surface.points={}", choice_.points)};
  outcome.chosen = fmt::format("{} points per side", choice_.points);
  for (const auto& [method, forecast] : choice_.methods) {
    for (std::string& one : overrides_at(*forecast, choice_.growth_share)) {
      outcome.chosen += ", " + one;
      outcome.overrides.push_back(std::move(one));
    }
    for (const std::string& quantity : quantities_)
      outcome.checks.push_back(
          {.quantity = quantity,
           .estimator = forecast->best_column(quantity, choice_.points,
                                              choice_.growth_share),
           .method = method,
           .predicted = forecast->error(quantity, choice_.points,
                                        choice_.growth_share)});
  }
}

TargetOutcome TargetSearch::choose(double target) {
  TargetOutcome outcome;
  outcome.target = target;
  if (grids_.empty()) {
    outcome.problem =
        "the case does not set surface.points; an error target needs it";
    return outcome;
  }
  if (forecasts_.empty())
    make_forecasts();
  if (find_choice(target)) {
    ++n_tries_;
    add_checks(outcome);
  } else {
    outcome.problem = why_none(target);
  }
  outcome.search_cpu_time = search_cpu_time_;
  return outcome;
}

} // namespace asperity::bench
