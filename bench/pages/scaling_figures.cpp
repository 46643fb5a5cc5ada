#include "bench/analysis/scaling.hpp"
#include "bench/pages/bench_report.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::bench {
namespace {

reports::Figure scaling_figure(const Bench& bench, bool has_ranks,
                               bool is_weak) {
  const char* const workers = has_ranks ? "ranks" : "threads";
  reports::Figure figure;
  figure.name =
      fmt::format("{}-scaling-{}", is_weak ? "weak" : "strong", workers);
  figure.title =
      fmt::format("{} scaling over {}", is_weak ? "Weak" : "Strong", workers);
  figure.caption = fmt::format(
      "{} Wall time of the whole run, medians; the grey line is ideal.",
      is_weak ? "The number of nodes grows in proportion to the workers, and "
                "the speed is in nodes per time."
              : "The same work on every number of workers.");
  reports::CsvTable table({"curve", "index", std::string(workers) + " [1]",
                           "speed-up [1]", "efficiency [1]"});
  reports::ChartPanel panel{
      .x = {.label = workers, .low = 0.9, .is_log = true, .base = 2},
      .y = {.label = "speed-up", .is_log = true, .base = 2},
      .curves = {{.label = "ideal",
                  .style = reports::line("#bbbbbb", 1.5),
                  .slope = 1.0}}};
  int most = 1;
  std::size_t index = 0;
  for (const ScalingSeries& series : bench.scaling) {
    if (series.has_ranks != has_ranks || series.is_weak != is_weak)
      continue;
    const std::vector<ScalingRow> rows = scaling_rows(bench, series);
    for (const ScalingRow& row : rows) {
      table.add(series.method, {static_cast<double>(index), double(row.workers),
                                row.speed_up, row.efficiency});
      most = std::max(most, row.workers);
    }
    if (!rows.empty())
      panel.add(series.method,
                reports::joined(reports::markers(reports::method_color(index),
                                                 7, 0.7, 1.4)),
                index, 3, 4);
    ++index;
  }
  figure.data = table.text();
  panel.x.high = 1.2 * most;
  panel.y.high = 1.5 * most;
  figure.panels = {std::move(panel)};
  return figure;
}

} // namespace

std::vector<reports::Figure> scaling_figures(const Bench& bench) {
  std::vector<reports::Figure> figures;
  for (const bool has_ranks : {false, true})
    for (const bool is_weak : {false, true})
      if (std::ranges::any_of(bench.scaling, [&](const ScalingSeries& series) {
            return series.has_ranks == has_ranks && series.is_weak == is_weak;
          }))
        figures.push_back(scaling_figure(bench, has_ranks, is_weak));
  return figures;
}

} // namespace asperity::bench
