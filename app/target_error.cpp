#include "app/target_error.hpp"

#include "app/case_values.hpp"
#include "app/sweep.hpp"
#include "app/sweep_axes.hpp"
#include "cases/vocabulary.hpp"
#include "reports/bench_answer.hpp"
#include "reports/bench_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity::app {
namespace {

using reports::BenchAnswer;
using reports::BenchPoint;
using reports::TargetOutcome;

constexpr int least_points = 32;
constexpr int most_points = 4096;

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

/// Of the layers; 1 where the method has none, or equal ones.
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
  const int least =
      std::max(least_points, least_carrying_points(contact_case.surface));
  int coarsest = own;
  while (coarsest % 4 == 0 && coarsest / 2 >= least)
    coarsest /= 2;
  if (4 * least <= 3 * coarsest) // a grid between
    coarsest = least;
  for (const int factor : {1, 2, 4})
    if (own > 0 && (factor <= 2 || factor * coarsest <= own))
      grids_.push_back(factor * coarsest);
}

BenchPoint TargetSearch::run_at(const std::string& method,
                                const std::string& element, int points,
                                double growth_share) {
  BenchPoint point;
  point.method = method;
  point.kind = kind_of_method(method);
  point.points = points;
  point.is_truth = true; // once is enough
  point.overrides = overrides_at({.method = method,
                                  .element = element,
                                  .growth = growth_of(case_, method)},
                                 growth_share);
  point.overrides.push_back(fmt::format("surface.points={}", points));
  runner_.run(point);
  search_cpu_time_ += point.problem.empty() ? point.cpu.median : 0.0;
  return point;
}

Forecast TargetSearch::forecast_of(const std::string& method,
                                   const std::string& element) {
  Forecast forecast{
      .method = method, .element = element, .growth = growth_of(case_, method)};
  std::vector<BenchPoint> coarse;
  for (const int points : grids_) {
    coarse.push_back(run_at(method, element, points, 1.0));
    if (!coarse.back().problem.empty()) {
      problem_ = fmt::format("{} on {} points: {}", method, points,
                             coarse.back().problem);
      return forecast;
    }
  }
  add_runs(forecast, coarse, quantities_);
  if (forecast.growth > 1.0)
    add_growth(forecast, coarse.front(),
               run_at(method, element, coarse.front().points, 0.5));
  return forecast;
}

void TargetSearch::make_forecasts() {
  for (const cases::MethodSpec& method : case_.methods)
    if (varies_with_points(kind_of_method(method.name)))
      for (const std::string& element : elements_of(case_, method.name))
        forecasts_.push_back(forecast_of(method.name, element));
}

double TargetSearch::largest_error(const Forecast& forecast, int points,
                                   double growth_share) const {
  double largest = 0.0;
  for (const std::string& quantity : quantities_)
    largest =
        std::fmax(largest, forecast.error(quantity, points, growth_share));
  return largest;
}

bool TargetSearch::choose_at(int points, double growth_share, double target,
                             Choice& choice) const {
  choice = {points, growth_share, 0.0, {}};
  for (const Forecast& forecast : forecasts_) {
    if (forecast.terms.empty() ||
        !(largest_error(forecast, points, growth_share) < target))
      continue;
    const Forecast*& best = choice.methods[forecast.method];
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

TargetOutcome TargetSearch::choose(double target) {
  TargetOutcome outcome;
  outcome.target = target;
  if (grids_.empty()) {
    outcome.problem = "the case does not choose its points";
    return outcome;
  }
  make_forecasts();
  outcome.search_cpu_time = search_cpu_time_;
  const int own = *case_.surface.points;
  const int last = std::max(std::min(4 * own, most_points), grids_.back());
  bool is_found = false;
  for (int base = grids_.front(); base <= last; base *= 2)
    for (const int points : {base, base + base / 2})
      for (const double growth_share : {1.0, 0.5, 0.25}) {
        Choice choice;
        if (points % 2 == 0 && points <= last &&
            choose_at(points, growth_share, target, choice) &&
            (!is_found || choice.cpu_time < choice_.cpu_time)) {
          choice_ = std::move(choice);
          is_found = true;
          break;
        }
      }
  if (!is_found) {
    double best = std::numeric_limits<double>::infinity();
    for (const Forecast& forecast : forecasts_)
      best = std::fmin(best, largest_error(forecast, last, 0.25));
    outcome.problem = fmt::format(
        "no setting up to {} points is predicted to err by less than {} in "
        "every quantity; the best method there is predicted {}{}{}",
        last, reports::per_cent(target), reports::per_cent(best),
        problem_.empty() ? "" : "; ", problem_);
    return outcome;
  }
  outcome.predicted_cpu_time = choice_.cpu_time;
  outcome.overrides = {fmt::format("surface.points={}", choice_.points)};
  outcome.chosen = fmt::format("{} points a side", choice_.points);
  for (const auto& [method, forecast] : choice_.methods) {
    for (std::string& one : overrides_at(*forecast, choice_.growth_share)) {
      outcome.chosen += ", " + one;
      outcome.overrides.push_back(std::move(one));
    }
    for (const std::string& quantity : quantities_) {
      reports::Promise promise{
          .quantity = quantity, .estimator = quantity, .method = method};
      promise.predicted =
          forecast->error(quantity, choice_.points, choice_.growth_share);
      for (const auto& [column, term] : forecast->terms)
        if (quantity == any_area && reports::is_area(column) &&
            forecast->error(column, choice_.points, choice_.growth_share) <=
                promise.predicted)
          promise.estimator = column;
      outcome.promises.push_back(promise);
    }
  }
  return outcome;
}

void TargetSearch::verify(TargetOutcome& outcome,
                          const std::map<std::string, BenchAnswer>& chosen) {
  const int finer_points = 2 * choice_.points;
  outcome.finer = fmt::format("one run a method on {} points with half the "
                              "logarithm of the layers' growth",
                              finer_points);
  if (!reports::exact_words(case_).empty())
    outcome.finer =
        "the exact solution where it answers, else " + outcome.finer;
  for (const auto& [method, forecast] : choice_.methods) {
    const auto answer = chosen.find(method);
    if (answer == chosen.end())
      continue;
    const BenchAnswer exact = reports::exact_answer(case_, answer->second);
    const BenchPoint finer = run_at(method, forecast->element, finer_points,
                                    0.5 * choice_.growth_share);
    for (reports::Promise& promise : outcome.promises) {
      if (promise.method != method)
        continue;
      promise.found =
          reports::error_against(exact, answer->second, promise.estimator);
      if (!std::isfinite(promise.found)) {
        const auto term = forecast->terms.find(promise.estimator);
        const double left =
            term == forecast->terms.end()
                ? 1.0
                : 1.0 / (1.0 - std::pow(2.0, -term->second.order));
        promise.found =
            left * reports::error_against(finer.answer, answer->second,
                                          promise.estimator);
      }
      promise.is_kept = promise.found < outcome.target;
    }
  }
}

TargetOutcome TargetSearch::run(double target) {
  TargetOutcome outcome = choose(target);
  if (!outcome.problem.empty())
    return outcome;
  std::map<std::string, BenchAnswer> chosen;
  outcome.cpu_time = 0.0;
  for (const auto& [method, forecast] : choice_.methods) {
    const BenchPoint point =
        run_at(method, forecast->element, choice_.points, choice_.growth_share);
    outcome.cpu_time += point.cpu.median;
    chosen[method] = point.answer;
  }
  verify(outcome, chosen);
  return outcome;
}

void print_outcome(const TargetOutcome& outcome) {
  if (!outcome.problem.empty()) {
    fmt::print("target error: {}\n", outcome.problem);
    return;
  }
  fmt::print("target error: {}; predicted {:.3g} s of CPU time\n",
             outcome.chosen, outcome.predicted_cpu_time);
  for (const reports::Promise& promise : outcome.promises)
    fmt::print("{} of {} ({}): promised {}, predicted {}, found {}: {}\n",
               promise.quantity, promise.method, promise.estimator,
               reports::per_cent(outcome.target),
               reports::per_cent(promise.predicted),
               reports::per_cent(promise.found),
               promise.is_kept ? "kept" : "NOT kept");
}

} // namespace asperity::app
