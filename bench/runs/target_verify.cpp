// Verifies whether an error target was met, and chooses what to try next if it
// was not.
#include "bench/analysis/bench_answer.hpp"
#include "bench/pages/bench_report.hpp"
#include "bench/runs/target_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity::bench {
namespace {

constexpr int most_tries = 3;

bool answers(const BenchAnswer& exact, const BenchAnswer& chosen,
             const TargetOutcome& outcome, const std::string& method) {
  return std::all_of(
      outcome.checks.begin(), outcome.checks.end(),
      [&](const TargetCheck& check) {
        return check.method != method ||
               std::isfinite(error_against(exact, chosen, check.estimator));
      });
}

/// Adds the part of the error that the difference from a run on twice the
/// points does not contain: the error of that run, 2^-order of the error
/// sought.
double with_what_is_left(double difference, double order) {
  return difference / (1.0 - std::pow(2.0, -order));
}

std::string broken_words(const TargetOutcome& outcome) {
  std::string words = fmt::format("{}:", outcome.chosen);
  for (const TargetCheck& check : outcome.checks)
    if (!check.is_met)
      words += fmt::format("{} the error of {} with {} was {}",
                           words.ends_with(':') ? "" : ",", check.quantity,
                           check.method, per_cent(check.found));
  return words;
}

} // namespace

void TargetSearch::verify_method(TargetOutcome& outcome, Forecast& forecast,
                                 const BenchAnswer& answer) {
  const BenchAnswer exact = exact_answer(case_, answer);
  BenchAnswer finer;
  if (!answers(exact, answer, outcome, forecast.method)) {
    finer = run_at(forecast.method, forecast.element, 2 * choice_.points,
                   0.5 * choice_.growth_share)
                .answer;
    outcome.finer =
        fmt::format("{}one run per method on {} points per side with half the "
                    "logarithm of the layers' grading ratio",
                    exact.values.empty()
                        ? ""
                        : "the exact solution where there is one, otherwise ",
                    2 * choice_.points);
  }
  std::map<std::string, double> found;
  for (const auto& [column, term] : forecast.terms) {
    found[column] = error_against(exact, answer, column);
    if (!std::isfinite(found[column]))
      found[column] =
          with_what_is_left(error_against(finer, answer, column), term.order);
  }
  bool is_met = true;
  for (TargetCheck& check : outcome.checks) {
    if (check.method != forecast.method)
      continue;
    check.found = found.at(check.estimator);
    check.is_met = check.found < outcome.target;
    is_met = is_met && check.is_met;
  }
  if (!is_met)
    for (const auto& [column, error] : found)
      forecast.learn(column, choice_.points, choice_.growth_share, error);
}

void TargetSearch::verify(TargetOutcome& outcome,
                          const std::map<std::string, BenchAnswer>& chosen) {
  outcome.finer = "the exact solution";
  for (const auto& [method, forecast] : choice_.methods)
    if (const auto answer = chosen.find(method); answer != chosen.end())
      verify_method(outcome, *forecast, answer->second);
  outcome.search_cpu_time = search_cpu_time_;
}

bool TargetSearch::choose_again(TargetOutcome& outcome) {
  if (n_tries_ >= most_tries) {
    outcome.earlier.push_back(
        fmt::format("the limit of {} settings is reached", most_tries));
    return false;
  }
  TargetOutcome next = choose(outcome.target);
  if (!next.problem.empty()) {
    outcome.earlier.push_back(
        "with this setting's result taken into account, " + next.problem);
    return false;
  }
  next.earlier = std::move(outcome.earlier);
  next.earlier.push_back(broken_words(outcome));
  outcome = std::move(next);
  return true;
}

TargetOutcome TargetSearch::run(double target) {
  TargetOutcome outcome = choose(target);
  bool is_open = outcome.problem.empty();
  while (is_open) {
    std::map<std::string, BenchAnswer> chosen;
    outcome.cpu_time = 0.0;
    for (const auto& [method, forecast] : choice_.methods) {
      const BenchPoint point = run_at(method, forecast->element, choice_.points,
                                      choice_.growth_share);
      outcome.cpu_time += point.cpu.median;
      chosen[method] = point.answer;
    }
    verify(outcome, chosen);
    is_open = !outcome.is_met() && choose_again(outcome);
  }
  return outcome;
}

} // namespace asperity::bench
