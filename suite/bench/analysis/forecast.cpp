#include "suite/bench/analysis/forecast.hpp"

#include "base/special_numbers.hpp"
#include "input/types/quantity_at_load.hpp"
#include "reports/analysis/summary.hpp"
#include "suite/bench/analysis/bench_answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity::bench {
namespace {

constexpr double lowest_order = 0.5;  // of an extrapolation
constexpr double highest_order = 2.0; // no extrapolation with a higher order
constexpr double order_unknown = 1.0;
constexpr const char* corrected_area = "area_fraction_corrected";

bool means(const std::string& quantity, const std::string& column) {
  return column == quantity || (quantity == any_area && is_area(column));
}

/// Requires the term of the corrected area.
double bias_of(const std::string& column, const Forecast::Term& term,
               const Forecast::Term& corrected, const BenchAnswer& finest) {
  const auto count = finest.values.find(corrected_area);
  const auto other = finest.values.find(column);
  const double difference = reports::rms_difference(
      other->second, count->second, scale_of(corrected_area, finest));
  return std::isfinite(difference)
             ? std::max(0.0, difference - term.error - corrected.error)
             : std::numeric_limits<double>::infinity();
}

/// Costs outside the steps may grow as the steps do (maps, subsurface stress).
/// Their noise must not make a finer grid appear cheaper, so the exponent is
/// that of the steps.
void add_cost(Forecast& forecast, std::span<const BenchPoint> coarse) {
  const auto rest = [](const BenchPoint& point) {
    return point.cpu.median - point.phases.steps();
  };
  const BenchPoint& first = coarse.front();
  const BenchPoint& last = coarse.back();
  const double more_steps = last.phases.steps() - first.phases.steps();
  const double share =
      more_steps > 0.0 ? std::fmax(0.0, rest(last) - rest(first)) / more_steps
                       : 0.0;
  std::vector<double> points;
  std::vector<double> times;
  for (const BenchPoint& point : coarse) {
    points.push_back(point.points);
    times.push_back((1.0 + share) * point.phases.steps());
  }
  forecast.step_time = reports::fit_power_law(points, times);
  forecast.fixed_time = std::fmax(0.0, first.cpu.median - times.front());
}

/// Determines the error and the order of a quantity from the finest two or
/// three of some runs. The order is the observed one if three runs have one,
/// otherwise 1, and is limited to 2, so that a coincidentally close pair does
/// not suggest too small an error.
/// @param coarse  runs with results, coarse to fine, at least two
Forecast::Term term_of(std::span<const BenchPoint> coarse,
                       const std::string& column) {
  const std::size_t n = coarse.size();
  const std::vector<double> scale = scale_of(column, coarse[n - 1].answer);
  // Difference between run i and the previous run.
  const auto difference = [&](std::size_t i) {
    const auto fine = coarse[i].answer.values.find(column);
    const auto rough = coarse[i - 1].answer.values.find(column);
    const bool is_known = fine != coarse[i].answer.values.end() &&
                          rough != coarse[i - 1].answer.values.end() &&
                          fine->second.size() == scale.size() &&
                          rough->second.size() == scale.size();
    return is_known
               ? reports::rms_difference(fine->second, rough->second, scale)
               : not_a_number;
  };
  Forecast::Term term;
  term.order = order_unknown;
  if (n >= 3) {
    const std::array spacings{1.0 / coarse[n - 3].points,
                              1.0 / coarse[n - 2].points,
                              1.0 / coarse[n - 1].points};
    const double order =
        reports::observed_order(spacings, difference(n - 2), difference(n - 1));
    if (std::isfinite(order))
      term.order = std::clamp(order, lowest_order, highest_order);
  }
  const double ratio = static_cast<double>(coarse[n - 1].points) /
                       static_cast<double>(coarse[n - 2].points);
  term.error = difference(n - 1) / (std::pow(ratio, term.order) - 1.0);
  return term;
}

} // namespace

std::string Forecast::best_column(const std::string& quantity, int points,
                                  double growth_share) const {
  std::string best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [column, term] : terms) {
    if (!means(quantity, column))
      continue;
    const double error = parts(column, points, growth_share).sum();
    if (error < least) {
      least = error;
      best = column;
    }
  }
  return best;
}

ErrorParts Forecast::parts(const std::string& column, int points,
                           double growth_share) const {
  const auto found = terms.find(column);
  if (found == terms.end())
    return {infinity, infinity, infinity};
  const Term& term = found->second;
  return {term.error *
              std::pow(static_cast<double>(finest) / points, term.order),
          term.floor * growth_share * growth_share, term.bias};
}

double Forecast::error(const std::string& quantity, int points,
                       double growth_share) const {
  return parts(best_column(quantity, points, growth_share), points,
               growth_share)
      .sum();
}

double Forecast::cpu_time(int points) const {
  return fixed_time + step_time.at(points);
}

void Forecast::learn(const std::string& column, int points, double growth_share,
                     double found) {
  const auto known = terms.find(column);
  const double excess = found - parts(column, points, growth_share).sum();
  if (known == terms.end() || !(excess > 0.0))
    return;
  Term& term = known->second;
  if (term.is_corrected)
    term.bias += excess;
  else
    term.error +=
        excess * std::pow(static_cast<double>(points) / finest, term.order);
  term.is_corrected = true;
}

std::vector<std::string> asked_quantities(const cases::Case& contact_case) {
  const std::string gap =
      contact_case.load.control == mechanics::Control::mean_gap
          ? "nominal_pressure"
          : "mean_gap";
  std::vector<std::string> asked;
  const auto add = [&](const std::string& name) {
    if (std::find(asked.begin(), asked.end(), name) == asked.end())
      asked.push_back(name);
  };
  const bool is_exact = reports::has_exact_curve(contact_case);
  for (const cases::Expectation& one : contact_case.expectations) {
    const std::string& name = one.quantity;
    if (name == "gap_deviation" || name == "mean_gap_error" ||
        name == "approach_error" || name == "pressure_difference")
      add(gap);
    else if (name.starts_with("area_") || name == "contact_radius_error")
      add(cases::names_a_load(name) && !is_exact ? name : any_area);
    else if (!is_exact &&
             (name.starts_with("gamma_") || name == "kappa" || name == "beta"))
      add(name);
  }
  if (asked.empty())
    asked = {gap, any_area};
  return asked;
}

void add_runs(Forecast& forecast, std::span<const BenchPoint> coarse,
              std::span<const std::string> quantities) {
  forecast.finest = coarse.back().points;
  add_cost(forecast, coarse);
  for (const std::string& quantity : quantities)
    for (const auto& [column, values] : coarse.back().answer.values)
      if (means(quantity, column))
        if (const Forecast::Term term = term_of(coarse, column);
            std::isfinite(term.error))
          forecast.terms[column] = term;
  const auto corrected = forecast.terms.find(corrected_area);
  for (auto& [column, term] : forecast.terms)
    if (is_area(column) && corrected != forecast.terms.end())
      term.bias =
          bias_of(column, term, corrected->second, coarse.back().answer);
}

void add_growth(Forecast& forecast, const BenchPoint& as_it_is,
                const BenchPoint& halved) {
  for (auto& [column, term] : forecast.terms) {
    const double difference =
        error_against(halved.answer, as_it_is.answer, column);
    term.floor = std::isfinite(difference) ? difference * 4.0 / 3.0 : 0.0;
  }
}

void add_exact(Forecast& forecast, std::span<const BenchPoint> coarse,
               std::span<const BenchAnswer> exact) {
  const std::size_t n = coarse.size();
  for (auto& [column, term] : forecast.terms) {
    const double fine =
        error_against(exact[n - 1], coarse[n - 1].answer, column);
    const double rough =
        error_against(exact[n - 2], coarse[n - 2].answer, column);
    if (!std::isfinite(fine) || !std::isfinite(rough))
      continue;
    const double fall = std::pow(static_cast<double>(coarse[n - 1].points) /
                                     coarse[n - 2].points,
                                 term.order);
    const double stays =
        std::clamp((fine * fall - rough) / (fall - 1.0), 0.0, fine);
    term.error = std::fmax(term.error, fine - stays);
    term.bias = std::fmax(0.0, stays - term.floor);
  }
}

} // namespace asperity::bench
