#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

std::optional<Figure> cost_figure(std::span<const Series> series,
                                  const FigureScales& scales) {
  Figure figure;
  figure.name = "cost";
  figure.title = "Cost of each step";
  figure.width = 860;
  figure.height = 360;
  CsvTable table(
      {"curve", "index", "p/E* [1]", "iterations [1]", "cpu_time [s]"});
  ChartAxis pressure = load_axis(series, scales);
  pressure.is_log = pressure.has_powers = true;
  ChartPanel iterations{.x = pressure,
                        .y = {.label = "iterations", .low = 0.0}};
  ChartPanel times{.x = pressure,
                   .y = {.label = "CPU time per step [s]", .low = 0.0}};
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    const bool has_times =
        std::ranges::any_of(one.rows, [](const SeriesRow& row) {
          return std::isfinite(row.cpu_time);
        });
    const Cost& cost = one.method->cost;
    // What another program has written may state neither.
    if (one.is_theory() || (!has_times && cost.largest_iterations == 0))
      continue;
    for (const SeriesRow& row : one.rows)
      table.add(one.label, {static_cast<double>(i), row.pressure,
                            row.iterations, row.cpu_time});
    const CurveStyle style = joined(point_style(one));
    iterations.add(one.label, style, i, 3, 4);
    times.add(one.label, style, i, 3, 5);
    figure.caption +=
        fmt::format("{}{}: {}at most {} iterations",
                    figure.caption.empty() ? "" : "; ", one.label,
                    has_times ? fmt::format("{:.2g} s per step (median), ",
                                            cost.step_cpu_time)
                              : "",
                    cost.largest_iterations);
  }
  if (iterations.curves.empty())
    return std::nullopt;
  figure.caption += ". CPU times, means over the realisations.";
  figure.panels = {std::move(iterations), std::move(times)};
  figure.grid = side_by_side(0.225);
  figure.data = table.text();
  return figure;
}

} // namespace

const ReportFigure figures::cost{.names = {"cost"},
                                 .section = FigureSection::cost,
                                 .draw = drawn_by<cost_figure>};

} // namespace asperity::reports
