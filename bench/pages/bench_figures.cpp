#include "bench/analysis/bench_answer.hpp"
#include "bench/pages/bench_report.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace asperity::bench {
namespace {

std::vector<std::string> methods_of(const Bench& bench) {
  std::vector<std::string> methods;
  for (const BenchPoint& point : bench.points)
    if (!point.is_reference && std::find(methods.begin(), methods.end(),
                                         point.method) == methods.end())
      methods.push_back(point.method);
  return methods;
}

reports::CurveStyle sign_of(std::size_t method, double width) {
  return reports::markers(reports::method_color(method),
                          4 + 2 * static_cast<int>(method % 5), 0.7, width);
}

double error_of(const BenchPoint& point, const std::string& quantity) {
  const auto found = point.errors.find(quantity);
  return found == point.errors.end() ? not_a_number : found->second;
}

std::string front_words(const Bench& bench,
                        const std::vector<std::size_t>& front) {
  std::string words;
  for (const std::size_t i : front) {
    const BenchPoint& point = bench.points[i];
    words += fmt::format("{}{} ({:.2g} s)", words.empty() ? "" : "; ",
                         point.method + ", " + point.label, point.cpu.median);
  }
  return words;
}

reports::Figure front_figure(const Bench& bench, const std::string& quantity,
                             const std::vector<std::size_t>& front) {
  reports::Figure figure;
  figure.name = "front-" + reports::file_word(quantity);
  figure.title = "Cost against error: " + quantity;
  figure.caption = error_words(quantity) +
                   ". The line is the Pareto front, the settings that no other "
                   "setting beats in both cost and error: " +
                   front_words(bench, front) + ".";
  const std::vector<std::string> methods = methods_of(bench);
  reports::CsvTable table({"curve", "index", "cpu_time [s]", "error [1]"});
  for (std::size_t m = 0; m < methods.size(); ++m)
    for (const BenchPoint& point : bench.points)
      if (point.method == methods[m] && !point.is_reference &&
          error_of(point, quantity) > 0.0)
        table.add(point.method, {static_cast<double>(m), point.cpu.median,
                                 error_of(point, quantity)});
  for (const std::size_t i : front)
    table.add("front",
              {static_cast<double>(methods.size()), bench.points[i].cpu.median,
               error_of(bench.points[i], quantity)});
  reports::ChartPanel panel{
      .x = {.label = "CPU time of the run [s]", .is_log = true},
      .y = {.label = "error", .is_log = true, .has_powers = true},
      .curves = {reports::curve("Pareto front", reports::line("#888888", 1.5),
                                methods.size(), 3, 4)}};
  panel.curves.front().has_steps = true;
  for (std::size_t m = 0; m < methods.size(); ++m)
    panel.add(methods[m], sign_of(m, 1.4), m, 3, 4);
  figure.data = table.text();
  figure.panels = {std::move(panel)};
  return figure;
}

/// The definition of a plot against the number of points.
struct AgainstPoints {
  std::string name;
  std::string title;
  std::string caption;
  std::string label; ///< label of the vertical axis
  std::function<double(const BenchPoint&)> value;
  std::function<reports::PowerLaw(const BenchSeries&)> law;
};

reports::Figure against_points(const Bench& bench, const AgainstPoints& what) {
  reports::Figure figure;
  figure.name = what.name;
  figure.title = what.title;
  reports::CsvTable table({"curve", "index", "points a side [1]", what.label});
  reports::ChartPanel panel{
      .x = {.label = "points per side", .is_log = true, .base = 2},
      .y = {.label = reports::as_markup(what.label),
            .is_log = true,
            .has_powers = true}};
  std::string exponents;
  std::size_t index = 0;
  for (const BenchSeries& series : bench.series) {
    if (series.axis != points_axis)
      continue;
    for (const std::size_t i : series.points)
      if (bench.points[i].problem.empty())
        table.add(series.method, {static_cast<double>(index),
                                  static_cast<double>(bench.points[i].points),
                                  what.value(bench.points[i])});
    panel.add(series.method, reports::joined(sign_of(index, 1.0)), index, 3, 4);
    if (const double exponent = what.law(series).determined_exponent();
        std::isfinite(exponent))
      exponents += fmt::format("{}{} {:.2f}", exponents.empty() ? "" : ", ",
                               series.method, exponent);
    ++index;
  }
  figure.caption = what.caption + exponents + ".";
  figure.data = table.text();
  figure.panels = {std::move(panel)};
  return figure;
}

reports::Figure convergence_figure(const Bench& bench,
                                   const std::string& quantity) {
  return against_points(
      bench, {"convergence-" + reports::file_word(quantity),
              "Error against the number of points: " + quantity,
              error_words(quantity) +
                  ". Errors are with respect to the reference solution. Slopes "
                  "of the error in the node spacing: ",
              "error",
              [&quantity](const BenchPoint& point) {
                return error_of(point, quantity);
              },
              [&quantity](const BenchSeries& series) {
                const auto order = series.orders.find(quantity);
                return order == series.orders.end() ? reports::PowerLaw{}
                                                    : order->second.error;
              }});
}

reports::Figure phases_figure(const Bench& bench) {
  reports::Figure figure;
  figure.name = "phases";
  figure.title = "Breakdown of the CPU time";
  figure.caption = "Shares of the CPU time of a run at the case's own setting. "
                   "The marker is the floor: the time of one forward and one "
                   "backward real transform in single precision, as in an "
                   "iteration of the solver, for each application of the "
                   "elastic operator or its inverse on the method's grid.";
  figure.width = 860;
  figure.height = 360;
  const std::vector<std::pair<const char*, double BenchPhases::*>> phases{
      {"set-up", &BenchPhases::setup},
      {"transforms", &BenchPhases::transforms},
      {"solving", &BenchPhases::solving},
      {"observation", &BenchPhases::observation},
      {"writing", &BenchPhases::writing},
      {"rest", &BenchPhases::rest}};
  bool has_floor = false;
  reports::CsvTable table({"setting", "setup [1]", "transforms [1]",
                           "solving [1]", "observation [1]", "writing [1]",
                           "rest [1]", "floor [1]"});
  for (const BenchPoint& point : bench.points) {
    if (!point.is_own || !point.problem.empty())
      continue;
    double sum = 0.0;
    for (const auto& [name, member] : phases)
      sum += point.phases.*member;
    std::vector<double> shares;
    shares.reserve(phases.size() + 1);
    for (const auto& [name, member] : phases)
      shares.push_back(point.phases.*member / sum);
    const double floor = point.transform_floor() / sum;
    has_floor = has_floor || floor > 0.0;
    shares.push_back(floor > 0.0 ? floor : not_a_number);
    table.add(point.method, shares);
  }
  reports::ChartPanel panel{
      .y = {.label = "share of the CPU time", .low = 0.0, .high = 1.02}};
  for (std::size_t i = 0; i < phases.size(); ++i)
    panel.curves.push_back({.label = phases[i].first,
                            .style = {.color = reports::method_color(i)},
                            .y = static_cast<int>(i) + 2,
                            .is_per_row = true});
  if (has_floor)
    panel.curves.push_back({.label = "transform floor",
                            .style = reports::markers("#000000", 7, 0.9),
                            .y = 8,
                            .is_per_row = true});
  figure.data = table.text();
  figure.panels = {std::move(panel)};
  return figure;
}

} // namespace

std::vector<reports::Figure> bench_figures(const Bench& bench) {
  std::vector<reports::Figure> figures;
  for (const std::string& quantity : bench.quantities)
    if (const auto front = bench.fronts.find(quantity);
        front != bench.fronts.end() && front->second.size() > 1)
      figures.push_back(front_figure(bench, quantity, front->second));
  const bool has_points = std::any_of(
      bench.series.begin(), bench.series.end(), [](const BenchSeries& series) {
        return series.axis == points_axis && series.points.size() > 1;
      });
  if (has_points) {
    for (const std::string& quantity : bench.quantities)
      if (bench.fronts.contains(quantity) && !bench.fronts.at(quantity).empty())
        figures.push_back(convergence_figure(bench, quantity));
    figures.push_back(against_points(
        bench,
        {"growth", "Cost against the number of points",
         "Median CPU time of a whole run. Fitted exponents in the number of "
         "points per side (2: proportional to the number of nodes): ",
         "CPU time [s]",
         [](const BenchPoint& point) { return point.cpu.median; },
         [](const BenchSeries& series) { return series.cost; }}));
    figures.push_back(against_points(
        bench, {"memory", "Peak memory", "Largest resident memory of a run",
                "peak memory [B]",
                [](const BenchPoint& point) { return point.peak_memory; },
                [](const BenchSeries&) { return reports::PowerLaw{}; }}));
  }
  figures.push_back(phases_figure(bench));
  return figures;
}

} // namespace asperity::bench
