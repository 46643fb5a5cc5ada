#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

namespace asperity::reports {

std::optional<Figure> cost_figure(std::span<const Series> series) {
  Figure figure;
  figure.name = "cost";
  figure.title = "Cost of each step";
  figure.width = 860;
  figure.height = 360;
  CsvTable table(
      {"curve", "index", "p/E* [1]", "iterations [1]", "cpu_time [s]"});
  std::vector<std::string> iterations;
  std::vector<std::string> times;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    if (one.is_theory() || one.rows.empty())
      continue;
    for (const SeriesRow& row : one.rows)
      table.add(one.label, {static_cast<double>(i), row.pressure,
                            row.iterations, row.cpu_time});
    const std::string ending = " with linespoints " + point_style(one) +
                               " title " + gnuplot_text(one.label);
    iterations.push_back("'cost.csv' " + of_series(i, "$3:4") + ending);
    times.push_back("'cost.csv' " + of_series(i, "$3:5") + ending);
    const Cost& cost = one.method->cost;
    figure.caption +=
        fmt::format("{}{}: {:.2g} s per step (median), at most {} iterations",
                    figure.caption.empty() ? "" : "; ", one.label,
                    cost.step_cpu_time, cost.largest_iterations);
  }
  if (iterations.empty())
    return std::nullopt;
  figure.caption += ". CPU times, means over the realisations.";
  figure.script = "set multiplot layout 1,2 margins 0.086,0.985,0.225,0.96 "
                  "spacing 0.09\nset key at screen 0.5, 0.02 bottom center "
                  "vertical maxrows 1\nset "
                  "logscale x\nset format x "
                  "'10^{%T}'\nset xlabel " +
                  gnuplot_markup("p / E*") +
                  "\nset ylabel 'iterations'\nset yrange [0:*]\n" +
                  plot_of(iterations) +
                  "unset yrange\nset ylabel 'CPU time per step [s]'\nset "
                  "yrange [0:*]\nunset key\n" +
                  plot_of(times) + "unset multiplot\n";
  figure.data = table.text();
  return figure;
}

} // namespace asperity::reports
