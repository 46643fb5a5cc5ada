#include "suite/bench/analysis/bench_analysis.hpp"

#include "base/field_sums.hpp"
#include "suite/bench/analysis/bench_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace asperity::bench {
namespace {

constexpr const char* best_area = "area_fraction_corrected";

/// The points of a series that have a result, coarse to fine.
struct Answered {
  std::vector<const BenchPoint*> points;
  std::vector<double> coordinates;
};

Answered answered(const Bench& bench, const BenchSeries& series) {
  Answered kept;
  for (std::size_t i = 0; i < series.points.size(); ++i) {
    const BenchPoint& point = bench.points[series.points[i]];
    if (!point.problem.empty())
      continue;
    kept.points.push_back(&point);
    if (i < series.coordinates.size())
      kept.coordinates.push_back(series.coordinates[i]);
  }
  return kept;
}

/// Returns the results of the finest settings that provide a quantity, coarse
/// to fine: the longest unbroken sequence at the end of the series.
std::vector<std::vector<double>> answers_to(const Answered& series,
                                            const std::string& quantity) {
  std::vector<std::vector<double>> answers;
  for (auto point = series.points.rbegin(); point != series.points.rend();
       ++point) {
    const auto found = (*point)->answer.values.find(quantity);
    if (found == (*point)->answer.values.end() || found->second.empty() ||
        !all_finite(found->second) ||
        (!answers.empty() && found->second.size() != answers.front().size()))
      break;
    answers.insert(answers.begin(), found->second);
  }
  return answers;
}

std::vector<std::string> quantities_of(const Bench& bench) {
  std::set<std::string> present;
  for (const BenchPoint& point : bench.points)
    for (const auto& [name, values] : point.answer.values)
      if (std::any_of(values.begin(), values.end(),
                      [](double value) { return std::isfinite(value); }))
        present.insert(name);
  std::vector<std::string> ordered;
  for (const char* first : {"mean_gap", "nominal_pressure"})
    if (present.erase(first) > 0)
      ordered.emplace_back(first);
  for (const std::string& name : present)
    if (is_area(name))
      ordered.push_back(name);
  for (const std::string& name : present)
    if (!is_area(name))
      ordered.push_back(name);
  return ordered;
}

void overlay_exact(const cases::Case& contact_case, const Bench& bench,
                   ReferenceSolution& reference) {
  for (const BenchPoint& point : bench.points) {
    if (!point.problem.empty() || point.kind == "theory")
      continue;
    const BenchAnswer exact = exact_answer(contact_case, point.answer);
    if (std::isnan(reference.answer.rms_height))
      reference.answer = exact;
    for (const auto& [name, values] : exact.values) {
      reference.answer.values[name] = values;
      reference.uncertainty[name] = 0.0;
      reference.is_exact[name] = true;
    }
    if (exact.values.contains(best_area)) // one reference for all estimators
      std::erase_if(reference.answer.values, [](const auto& entry) {
        return is_area(entry.first) && entry.first != best_area;
      });
    return;
  }
}

/// Describes which quantities of the reference solution are exact and which are
/// limits.
std::string reference_words(const ReferenceSolution& reference,
                            const Bench& bench,
                            const cases::Case& contact_case) {
  std::string words;
  if (std::any_of(reference.is_exact.begin(), reference.is_exact.end(),
                  [](const auto& entry) { return entry.second; }))
    words = exact_words(contact_case);
  if (reference.series >= bench.series.size())
    return words;
  std::string series;
  for (const BenchPoint* point :
       answered(bench, bench.series[reference.series]).points)
    series += fmt::format("{}{}", series.empty() ? "" : ", ", point->points);
  const bool is_mixed = !words.empty();
  words +=
      fmt::format("{}the limit of {} with hard contact on {} points per "
                  "side of the same surface{}",
                  is_mixed ? "; " : "", bench.series[reference.series].method,
                  series, is_mixed ? " for all other quantities" : "");
  return words;
}

void fill_errors(Bench& bench) {
  std::map<std::string, ReferenceSolution> own;
  for (const BenchSeries& series : bench.series)
    if (!series.coordinates.empty() && !own.contains(series.method))
      own[series.method] = limit_of(bench, series);
  for (BenchPoint& point : bench.points)
    for (const std::string& quantity : bench.quantities) {
      point.errors[quantity] =
          error_against(bench.reference.answer, point.answer, quantity);
      point.own_errors[quantity] =
          own.contains(point.method)
              ? error_against(own[point.method].answer, point.answer, quantity)
              : not_a_number;
    }
}

BenchOrder order_of(const Bench& bench, const BenchSeries& series,
                    const Answered& kept, const std::string& quantity) {
  BenchOrder order;
  const std::vector<std::vector<double>> answers = answers_to(kept, quantity);
  if (answers.size() >= 3) {
    BenchAnswer scale = kept.points.back()->answer;
    const std::vector<double> measure = scale_of(quantity, scale);
    const std::span<const double> h(kept.coordinates);
    const std::size_t n = answers.size();
    order.by_differences = reports::observed_order(
        std::span<const double, 3>(h.last(3)),
        reports::rms_difference(answers[n - 3], answers[n - 2], measure),
        reports::rms_difference(answers[n - 2], answers[n - 1], measure));
  }
  if (series.axis != "surface.points")
    // Along other axes, the error includes contributions of the fixed settings.
    return order;
  std::vector<double> errors;
  for (const BenchPoint* point : kept.points)
    errors.push_back(point->errors.at(quantity));
  if (bench.reference.answer.values.empty())
    return order;
  order.error = reports::fit_power_law(kept.coordinates, errors);
  return order;
}

void fill_series(Bench& bench, BenchSeries& series) {
  const Answered kept = answered(bench, series);
  if (!series.coordinates.empty())
    for (const std::string& quantity : bench.quantities)
      series.orders[quantity] = order_of(bench, series, kept, quantity);
  if (series.axis != "surface.points")
    return;
  std::vector<double> points;
  std::vector<double> cpu;
  std::vector<double> step_cpu;
  std::vector<double> unknowns;
  std::vector<double> block_cpu;
  for (const BenchPoint* point : kept.points) {
    points.push_back(point->points);
    cpu.push_back(point->cpu.median);
    step_cpu.push_back(point->phases.steps());
    unknowns.push_back(point->unknowns);
    block_cpu.push_back(point->phases.setup + point->phases.steps());
  }
  series.cost = reports::fit_power_law(points, cpu);
  series.step_cost = reports::fit_power_law(points, step_cpu);
  if (bench.reference.answer.values.empty())
    return;
  for (const std::string& quantity : bench.quantities) {
    std::vector<double> errors;
    errors.reserve(kept.points.size());
    for (const BenchPoint* point : kept.points)
      errors.push_back(point->errors.at(quantity));
    series.against_unknowns[quantity] =
        reports::fit_power_law(unknowns, errors);
    series.against_cpu_time[quantity] =
        reports::fit_power_law(block_cpu, errors);
  }
}

/// Returns the points of the bench on the Pareto front of a quantity, in
/// ascending cost. Only settings of elastic methods with a result are included,
/// without those of the reference series.
std::vector<std::size_t> front_of(const Bench& bench,
                                  const std::string& quantity) {
  std::vector<double> costs;
  std::vector<double> errors;
  for (const BenchPoint& point : bench.points) {
    const auto found = point.errors.find(quantity);
    const bool counts =
        point.is_elastic && !point.is_reference && found != point.errors.end();
    costs.push_back(point.cpu.median);
    errors.push_back(counts ? found->second : not_a_number);
  }
  return reports::pareto_front(costs, errors);
}

} // namespace

ReferenceSolution limit_of(const Bench& bench, const BenchSeries& series) {
  ReferenceSolution reference;
  const Answered kept = answered(bench, series);
  if (kept.points.empty())
    return reference;
  const BenchAnswer& finest = kept.points.back()->answer;
  reference.answer = finest;
  reference.answer.values.clear();
  for (const auto& [quantity, values] : finest.values) {
    const std::vector<std::vector<double>> answers = answers_to(kept, quantity);
    if (answers.empty())
      continue;
    const std::span<const double> h(kept.coordinates);
    const reports::RefinementLimit limit = reports::refinement_limit(
        answers, h.last(answers.size()), scale_of(quantity, finest));
    reference.answer.values[quantity] = limit.values;
    reference.uncertainty[quantity] = limit.uncertainty;
    reference.order[quantity] = limit.order;
    reference.is_exact[quantity] = false;
  }
  return reference;
}

void analyse(Bench& bench, const cases::Case& contact_case) {
  bench.quantities = quantities_of(bench);
  const std::size_t series = bench.reference.series;
  if (series < bench.series.size())
    bench.reference = limit_of(bench, bench.series[series]);
  bench.reference.series = series;
  // All estimators of the area have one reference: the one that converges
  // fastest.
  std::erase_if(bench.reference.answer.values, [](const auto& entry) {
    return is_area(entry.first) && entry.first != best_area;
  });
  overlay_exact(contact_case, bench, bench.reference);
  bench.reference.words = reference_words(bench.reference, bench, contact_case);
  fill_errors(bench);
  for (BenchSeries& one : bench.series)
    fill_series(bench, one);
  for (const std::string& quantity : bench.quantities)
    bench.fronts[quantity] = front_of(bench, quantity);
}

} // namespace asperity::bench
