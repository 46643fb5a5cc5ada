#include "bench/analysis/bench_answer.hpp"
#include "bench/pages/bench_report.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::bench {
namespace {

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

/// What the errors are drawn against.
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
  reports::Figure figure;
  figure.name = cost.name;
  figure.title = cost.title;
  reports::CsvTable table({"curve", "index", cost.label, "error [1]"});
  reports::ChartPanel panel{
      .x = {.label = reports::as_markup(cost.label),
            .is_log = true,
            .has_powers = true},
      .y = {.label = "error", .is_log = true, .has_powers = true}};
  std::size_t index = 0;
  for (const BenchSeries* series : block_series(bench, quantity)) {
    for (const std::size_t i : series->points)
      if (const BenchPoint& point = bench.points[i]; point.problem.empty())
        table.add(series->method,
                  {static_cast<double>(index), cost.value(point),
                   point.errors.at(quantity)});
    const double exponent =
        (series->*cost.laws).at(quantity).determined_exponent();
    const std::string name =
        std::isfinite(exponent)
            ? fmt::format("{}, order {:.2f}", series->method, -exponent)
            : series->method;
    panel.add(name,
              reports::joined(reports::markers(
                  reports::method_color(index),
                  4 + 2 * static_cast<int>(index % 5), 0.8, 1.4)),
              index, 3, 4);
    ++index;
  }
  figure.caption = error_words(quantity) + ". " + cost.caption;
  figure.data = table.text();
  figure.panels = {std::move(panel)};
  return figure;
}

} // namespace

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
