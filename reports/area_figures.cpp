#include "reports/figures.hpp"
#include "reports/html_report.hpp"
#include "reports/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

std::string area_caption(const Series* fitted, double scale) {
  std::string caption =
      "Signs: contact counted node by node. Coloured lines: the "
      "same with the area at the contact's rim corrected.";
  if (fitted != nullptr && quantity(*fitted, "area_excess").has_value())
    caption += fmt::format(
        " Counted, {} has {:+.0f} % of contact against the theory at light "
        "load.",
        fitted->label, 100.0 * quantity(*fitted, "area_excess").value);
  if (std::isfinite(scale))
    caption +=
        fmt::format(" Dashed: the theory scaled by {:.3g} to {}'s fitted κ.",
                    scale, fitted->label);
  return caption;
}

} // namespace

Figure area_figure(std::span<const Series> series) {
  constexpr double largest_area = 0.4; // where the near-linear part is over
  Figure figure;
  figure.name = "area-pressure";
  figure.title = "Contact area against pressure";
  CsvTable table({"curve", "index", "p/E* [1]", "A/A_0 counted [1]",
                  "A/A_0 corrected [1]", "A/A_0 scaled [1]"});
  const Series* fitted = first_numerical(series);
  const Series* theory =
      fitted == nullptr ? nullptr : theory_of(series, *fitted);
  double scale = not_a_number;
  if (theory != nullptr)
    scale = quantity(*fitted, "kappa").value / quantity(*theory, "kappa").value;
  std::vector<std::string> plots;
  const std::string file = "'area-pressure.csv' ";
  double furthest = 0.0;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (const SeriesRow& row : one.rows) {
      table.add(one.label, {static_cast<double>(i), row.pressure, row.area,
                            row.area_corrected,
                            &one == theory ? scale * row.area : not_a_number});
      if (row.area <= largest_area)
        furthest = std::max(furthest, row.pressure);
    }
    if (one.rows.empty() || !one.is_drawn)
      continue;
    const std::string title = gnuplot_text(one.legend);
    if (one.is_theory()) {
      plots.push_back(file + of_series(i, "$3:4") + " with lines " +
                      line_style(one) + " title " + title);
      if (&one == theory && std::isfinite(scale))
        plots.push_back(
            file + of_series(i, "$3:6") +
            " with lines linewidth 1.2 dashtype 2 linecolor rgb '#222222' "
            "title " +
            gnuplot_text(fmt::format("{} × {:.3g}", one.label, scale)));
      continue;
    }
    plots.push_back(file + of_series(i, "$3:4") + " with points " +
                    point_style(one) + " title " + gnuplot_text(one.legend));
    plots.push_back(file + of_series(i, "$3:5") + " with lines " +
                    line_style(one) + " notitle");
  }
  figure.caption = area_caption(fitted, scale) + joined_words(series);
  figure.script =
      fmt::format("set xlabel {}\nset ylabel {}\nset xrange "
                  "[0:{:.6g}]\nset yrange [0:{}]\n{}",
                  gnuplot_markup("p / E*"), gnuplot_markup("A / A_0"),
                  furthest > 0.0 ? 1.1 * furthest : 1.0, 1.2 * largest_area,
                  plot_of(plots));
  figure.data = table.text();
  return figure;
}

Figure area_coefficient_figure(std::span<const Series> series) {
  Figure figure;
  figure.name = "area-coefficient";
  figure.title = "The constant of proportionality of area and load";
  CsvTable table({"curve", "index", "A/A_0 counted [1]",
                  "A E* h'/(A_0 p) counted [1]", "A/A_0 corrected [1]",
                  "A E* h'/(A_0 p) corrected [1]"});
  std::vector<std::string> plots;
  const std::string file = "'area-coefficient.csv' ";
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (const SeriesRow& row : one.rows)
      if (row.area > 0.0)
        table.add(one.label, {static_cast<double>(i), row.area,
                              row.area / row.pressure_slope, row.area_corrected,
                              row.area_corrected / row.pressure_slope});
    if (one.rows.empty() || !one.is_drawn)
      continue;
    if (one.is_theory()) {
      plots.push_back(file + of_series(i, "$3:4") + " with lines " +
                      line_style(one) + " title " + gnuplot_text(one.label));
      continue;
    }
    plots.push_back(file + of_series(i, "$3:4") + " with points " +
                    point_style(one) + " title " + gnuplot_text(one.legend));
    plots.push_back(file + of_series(i, "$5:6") + " with lines " +
                    line_style(one) + " notitle");
  }
  figure.caption = "Signs: counted; coloured lines: corrected. κ is where a "
                   "curve meets the left edge, on a line through "
                   "its rows with A/A₀ ≤ 15 %.";
  std::string limits;
  for (const Series& one : series)
    if (quantity(one, "kappa").has_value())
      limits += fmt::format("{}{} {}", limits.empty() ? " Fitted: " : ", ",
                            one.label, number_text(quantity(one, "kappa")));
  if (!limits.empty())
    figure.caption += limits + ".";
  figure.caption += " Dotted: √(8/π) of Persson and √(2π) of Bush, Gibson and "
                    "Thomas." +
                    joined_words(series);
  plots.push_back("sqrt(8/pi) with lines linewidth 0.8 dashtype 3 linecolor "
                  "rgb '#777777' notitle");
  plots.push_back("sqrt(2*pi) with lines linewidth 0.8 dashtype 3 linecolor "
                  "rgb '#777777' notitle");
  figure.script = "set xlabel " + gnuplot_markup("A / A_0") + "\nset ylabel " +
                  gnuplot_markup("A E* h' / (A_0 p)") +
                  "\nset xrange [0:1]\nset yrange [0.8:3.2]\n" + plot_of(plots);
  figure.data = table.text();
  return figure;
}

} // namespace asperity::reports
