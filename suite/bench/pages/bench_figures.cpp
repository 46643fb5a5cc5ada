#include "reports/figures/plot_parts.hpp"
#include "suite/bench/analysis/bench_answer.hpp"
#include "suite/bench/pages/bench_report.hpp"

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

reports::CurveStyle sign_of(std::size_t method, double size, double width) {
  return reports::markers(reports::method_color(method),
                          4 + 2 * static_cast<int>(method % 5), size, width);
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
          number_of(point.errors, quantity) > 0.0)
        table.add(point.method, {static_cast<double>(m), point.cpu.median,
                                 number_of(point.errors, quantity)});
  for (const std::size_t i : front)
    table.add("front",
              {static_cast<double>(methods.size()), bench.points[i].cpu.median,
               number_of(bench.points[i].errors, quantity)});
  reports::ChartPanel panel{
      .x = {.label = "CPU time of the run [s]", .is_log = true},
      .y = {.label = "error", .is_log = true, .has_powers = true},
      .curves = {reports::curve("Pareto front", reports::line("#888888", 1.5),
                                methods.size(), 3, 4)}};
  panel.curves.front().has_steps = true;
  for (std::size_t m = 0; m < methods.size(); ++m)
    panel.add(methods[m], sign_of(m, 0.7, 1.4), m, 3, 4);
  figure.data = table.text();
  figure.panels = {std::move(panel)};
  return figure;
}

/// A plot of series: a curve for each of them, with a marker per setting.
struct SeriesPlot {
  std::string name;
  std::string title;
  std::string caption;
  std::vector<const BenchSeries*> series;
  std::string x_column;
  std::string y_column;
  reports::ChartAxis x;
  reports::ChartAxis y;
  std::function<double(const BenchPoint&)> x_of;
  std::function<double(const BenchPoint&)> y_of;
  std::function<std::string(const BenchSeries&)> curve_of; ///< its name
  std::function<reports::CurveStyle(std::size_t)> style_of;
};

reports::Figure series_figure(const Bench& bench, const SeriesPlot& plot) {
  reports::Figure figure;
  figure.name = plot.name;
  figure.title = plot.title;
  figure.caption = plot.caption;
  reports::CsvTable table({"curve", "index", plot.x_column, plot.y_column});
  reports::ChartPanel panel{.x = plot.x, .y = plot.y};
  std::size_t index = 0;
  for (const BenchSeries* series : plot.series) {
    for (const std::size_t i : series->points)
      if (const BenchPoint& point = bench.points[i]; point.problem.empty())
        table.add(series->method, {static_cast<double>(index), plot.x_of(point),
                                   plot.y_of(point)});
    panel.add(plot.curve_of(*series), reports::joined(plot.style_of(index)),
              index, 3, 4);
    ++index;
  }
  figure.data = table.text();
  figure.panels = {std::move(panel)};
  return figure;
}

/// What is drawn against the points per side.
struct AgainstPoints {
  std::string name;
  std::string title;
  std::string caption; ///< in front of the fitted exponents
  std::string label;   ///< label of the vertical axis
  std::function<double(const BenchPoint&)> value;
  std::function<reports::PowerLaw(const BenchSeries&)> law;
};

reports::Figure against_points(const Bench& bench, const AgainstPoints& what) {
  std::vector<const BenchSeries*> drawn;
  std::string exponents;
  for (const BenchSeries& series : bench.series) {
    if (series.axis != points_axis)
      continue;
    drawn.push_back(&series);
    if (const double exponent = what.law(series).determined_exponent();
        std::isfinite(exponent))
      exponents += fmt::format("{}{} {:.2f}", exponents.empty() ? "" : ", ",
                               series.method, exponent);
  }
  return series_figure(
      bench, {what.name,
              what.title,
              what.caption + exponents + ".",
              std::move(drawn),
              "points a side [1]",
              what.label,
              {.label = "points per side", .is_log = true, .base = 2},
              {.label = reports::as_markup(what.label),
               .is_log = true,
               .has_powers = true},
              [](const BenchPoint& point) { return double(point.points); },
              what.value,
              [](const BenchSeries& series) { return series.method; },
              [](std::size_t index) { return sign_of(index, 0.7, 1.0); }});
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
                return number_of(point.errors, quantity);
              },
              [&quantity](const BenchSeries& series) {
                const auto order = series.orders.find(quantity);
                return order == series.orders.end() ? reports::PowerLaw{}
                                                    : order->second.error;
              }});
}

/// The series over points of finite elements that have errors in the quantity.
std::vector<const BenchSeries*> block_series(const Bench& bench,
                                             const std::string& quantity) {
  std::vector<const BenchSeries*> found;
  for (const BenchSeries& series : bench.series) {
    const auto law = series.against_unknowns.find(quantity);
    if (!series.points.empty() &&
        bench.points[series.points.front()].kind == "fem" &&
        law != series.against_unknowns.end() && law->second.is_known())
      found.push_back(&series);
  }
  return found;
}

/// Whether the series has more unknowns than the surface has nodes.
bool is_full(const Bench& bench, const BenchSeries& series) {
  return std::ranges::any_of(series.points, [&](std::size_t i) {
    const BenchPoint& point = bench.points[i];
    return point.unknowns > double(point.points) * point.points;
  });
}

/// Returns the first quantity that shows the convergence of all blocks; empty
/// if no full block has errors in any.
std::string compared_quantity(const Bench& bench) {
  for (const char* quantity :
       {pressure_field, "elastic_energy", "mean_gap", "nominal_pressure"}) {
    const std::vector<const BenchSeries*> found = block_series(bench, quantity);
    if (std::ranges::any_of(found, [&](const BenchSeries* series) {
          return is_full(bench, *series);
        }))
      return quantity;
  }
  return "";
}

/// What the errors of blocks are drawn against.
struct Cost {
  std::string name;
  std::string title;
  std::string label;
  std::string caption;
  double (*value)(const BenchPoint&);
  std::map<std::string, reports::PowerLaw> BenchSeries::*laws;
};

reports::Figure block_figure(const Bench& bench, const std::string& quantity,
                             const Cost& cost) {
  const auto curve_of = [&](const BenchSeries& series) {
    const double exponent =
        (series.*cost.laws).at(quantity).determined_exponent();
    return std::isfinite(exponent)
               ? fmt::format("{}, order {:.2f}", series.method, -exponent)
               : series.method;
  };
  return series_figure(
      bench,
      {cost.name,
       cost.title,
       error_words(quantity) + ". " + cost.caption,
       block_series(bench, quantity),
       cost.label,
       "error [1]",
       {.label = reports::as_markup(cost.label),
        .is_log = true,
        .has_powers = true},
       {.label = "error", .is_log = true, .has_powers = true},
       cost.value,
       [&](const BenchPoint& point) { return point.errors.at(quantity); },
       curve_of,
       [](std::size_t index) { return sign_of(index, 0.8, 1.4); }});
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

std::vector<reports::Figure> block_figures(const Bench& bench) {
  const std::string quantity = compared_quantity(bench);
  if (quantity.empty())
    return {};
  return {
      block_figure(
          bench, quantity,
          {"blocks-unknowns", "Blocks: error against unknowns", "unknowns [1]",
           "The largest number of unknowns over the load steps; the "
           "condensed block counts the nodes of its surface. The order "
           "r is a decrease as (unknowns)^-r.",
           [](const BenchPoint& point) { return point.unknowns; },
           &BenchSeries::against_unknowns}),
      block_figure(
          bench, quantity,
          {"blocks-cpu", "Blocks: error against CPU time", "CPU time [s]",
           "CPU time of set-up and load steps, without the start of "
           "the program and its files. The order r means a decrease as "
           "(CPU time)^-r.",
           [](const BenchPoint& point) {
             return point.phases.setup + point.phases.steps();
           },
           &BenchSeries::against_cpu_time})};
}

} // namespace asperity::bench
