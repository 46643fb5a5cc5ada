#include "suite/bench/runs/target_error.hpp"

#include "input/reader/vocabulary.hpp"
#include "suite/bench/analysis/bench_answer.hpp"
#include "suite/bench/pages/bench_report.hpp"
#include "suite/bench/settings/bench_axes.hpp"
#include "suite/bench/settings/bench_plan.hpp"
#include "suite/bench/settings/block_settings.hpp"
#include "suite/bench/settings/case_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

constexpr double finest_growth = 0.25; ///< factor of ln g

/// The smallest error that a method can achieve, and its quantity.
struct Miss {
  const Forecast* forecast = nullptr;
  std::string quantity;
  double error = std::numeric_limits<double>::infinity();
};

/// Returns the quantity with the largest error for that method and element.
Miss worst_of(const Forecast& forecast,
              const std::vector<std::string>& quantities, int points) {
  Miss worst{&forecast, quantities.front(), -1.0};
  for (const std::string& quantity : quantities) {
    const double error = forecast.error(quantity, points, finest_growth);
    if (error > worst.error)
      worst = {&forecast, quantity, error};
  }
  return worst;
}

/// Returns the smallest achievable error by method, with its best element.
std::map<std::string, Miss> misses(const std::vector<Forecast>& forecasts,
                                   const std::vector<std::string>& quantities,
                                   int points) {
  std::map<std::string, Miss> best;
  for (const Forecast& forecast : forecasts) {
    const Miss miss = worst_of(forecast, quantities, points);
    Miss& known = best[forecast.method];
    if (known.forecast == nullptr || miss.error < known.error)
      known = miss;
  }
  return best;
}

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

std::string numbers_of(const TargetOutcome& outcome, const TargetCheck& check) {
  return fmt::format("target {}, predicted {}, found {}",
                     per_cent(outcome.target), per_cent(check.predicted),
                     per_cent(check.found));
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
  point.kind = cases::kind_of_method(method);
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
    if (varies_with_points(cases::kind_of_method(method.name)))
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

std::string TargetSearch::depth_words(const Forecast& forecast,
                                      const std::string& column) {
  const CaseValues values(case_);
  for (const char* key : {"depth", "thickness"}) {
    const auto own = values.value(forecast.method, key);
    const std::string twice = own ? scaled_value(*own, 2.0) : "";
    if (twice.empty())
      continue;
    const int points = grids_.front();
    const BenchPoint as_it_is =
        run_at(forecast.method, forecast.element, points, 1.0);
    const BenchPoint deeper =
        run_at(forecast.method, forecast.element, points, 1.0,
               {fmt::format("{}.{}={}", forecast.method, key, twice)});
    const double change = error_against(deeper.answer, as_it_is.answer, column);
    if (std::isfinite(change))
      return fmt::format("; doubling the {} changes it by {}", key,
                         per_cent(change));
  }
  return "";
}

std::string TargetSearch::why_none(double target) {
  const int last = finest_points();
  std::string words = fmt::format("no setting up to {} points per side has a "
                                  "predicted error below {} in every quantity",
                                  last, per_cent(target));
  for (const auto& [method, miss] : misses(forecasts_, quantities_, last)) {
    if (miss.error < target)
      continue;
    if (!std::isfinite(miss.error)) {
      words += fmt::format("; {} has no predicted error of {}", method,
                           miss.quantity);
      continue;
    }
    const std::string column =
        miss.forecast->best_column(miss.quantity, last, finest_growth);
    const ErrorParts parts = miss.forecast->parts(column, last, finest_growth);
    words += fmt::format("; {} has an error of {} in {}", method,
                         per_cent(miss.error), miss.quantity);
    if (parts.staying < 0.5 * miss.error)
      continue;
    words += fmt::format(", of which {} is independent of the grid",
                         per_cent(parts.staying));
    if (const std::string exact = exact_words(case_); !exact.empty())
      words += fmt::format(
          ": the case's block differs from that of the exact solution ({}){}",
          exact, depth_words(*miss.forecast, column));
  }
  if (!problem_.empty())
    words += fmt::format("; {}", problem_);
  return words;
}

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

void print_outcome(const TargetOutcome& outcome) {
  if (!outcome.problem.empty()) {
    fmt::print("target error: {}\n", outcome.problem);
    return;
  }
  for (const std::string& words : outcome.earlier)
    fmt::print("target error, earlier attempt: {}\n", words);
  fmt::print("target error: {}; predicted {:.3g} s of CPU time\n",
             outcome.chosen, outcome.predicted_cpu_time);
  for (const TargetCheck& check : outcome.checks)
    fmt::print("{} of {} ({}): {}: {}\n", check.quantity, check.method,
               check.estimator, numbers_of(outcome, check),
               check.is_met ? "met" : "MISSED");
}

results::Provenance facts_of(const TargetOutcome& outcome) {
  results::Provenance facts{{"target error", per_cent(outcome.target)},
                            {"target error, verified", outcome.finer}};
  for (std::size_t i = 0; i < outcome.earlier.size(); ++i)
    facts.emplace_back(fmt::format("target error, before ({})", i + 1),
                       outcome.earlier[i]);
  for (const TargetCheck& check : outcome.checks)
    facts.emplace_back(
        fmt::format("target error, {} of {}", check.quantity, check.method),
        fmt::format("{}: {} ({})", numbers_of(outcome, check),
                    check.is_met ? "met" : "missed", check.estimator));
  return facts;
}

} // namespace asperity::bench
