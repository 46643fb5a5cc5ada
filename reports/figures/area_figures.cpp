#include "base/shown_number.hpp"
#include "reports/analysis/area_scale.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/numbers/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::reports {
namespace {

// Describes the fitted factor, for example "1.31; 1.5 over the lighter half of
// the loads, 1.3 over the heavier".
std::string scale_words(const Series& fitted) {
  const Estimate& all =
      quantity(fitted, area_scale_name(false, LoadRange::all));
  std::string words = fmt::format(
      " Dashed: the theory times {}, the least-squares factor to {}'s counted "
      "area {}.",
      number_text(all), fitted.label, all.remark);
  const Estimate& light =
      quantity(fitted, area_scale_name(false, LoadRange::lower_half));
  const Estimate& heavy =
      quantity(fitted, area_scale_name(false, LoadRange::upper_half));
  const Estimate& corrected =
      quantity(fitted, area_scale_name(true, LoadRange::all));
  if (light.has_value() && heavy.has_value())
    words += fmt::format(" Over the lighter half of these loads it is {}, over "
                         "the heavier {}.",
                         number_text(light), number_text(heavy));
  if (corrected.has_value())
    words +=
        fmt::format(" To the corrected area it is {}.", number_text(corrected));
  return words;
}

std::string area_caption(const Series* fitted) {
  std::string caption =
      "Markers: contact area counted node by node. Coloured lines: the same "
      "with the area at the contact boundary corrected.";
  if (fitted == nullptr)
    return caption;
  if (quantity(*fitted, "area_excess").has_value())
    caption += fmt::format(
        " The counted area of {} differs by {:+.0f} % from "
        "the theory at light load.",
        fitted->label, Shown{100.0 * quantity(*fitted, "area_excess").value});
  if (quantity(*fitted, "area_scale").has_value())
    caption += scale_words(*fitted);
  return caption;
}

} // namespace

Figure area_figure(std::span<const Series> series) {
  Figure figure;
  figure.name = "area-pressure";
  figure.title = "Contact area against pressure";
  CsvTable table({"curve", "index", "p/E* [1]", "A/A_0 counted [1]",
                  "A/A_0 corrected [1]", "A/A_0 scaled [1]"});
  const Series* fitted = first_numerical(series);
  const Series* theory =
      fitted == nullptr ? nullptr : theory_of(series, *fitted);
  const double scale =
      theory != nullptr ? quantity(*fitted, "area_scale").value : not_a_number;
  std::vector<std::string> plots;
  Bands bands;
  const std::string file = "'area-pressure.csv' ";
  double furthest = 0.0;
  double top = 0.0;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (const SeriesRow& row : one.rows) {
      table.add(one.label, {static_cast<double>(i), row.pressure, row.area,
                            row.area_corrected,
                            &one == theory ? scale * row.area : not_a_number});
      furthest = std::max(furthest, row.pressure);
      top = std::max({top, row.area, row.area_corrected});
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
    bands.add(area_band(one.rows), series_color(one));
  }
  if (plots.empty())
    figure.problem = "no load step converged";
  bands.add_to(figure, plots);
  figure.caption = area_caption(fitted) + joined_words(series);
  if (!bands.empty())
    figure.caption += " Bands: 95 % interval of the mean counted area over the "
                      "realisations.";
  figure.script =
      fmt::format("set xlabel {}\nset ylabel {}\nset xrange "
                  "[0:{:.6g}]\nset yrange [0:{:.4g}]\n{}",
                  gnuplot_markup("p / E*"), gnuplot_markup("A / A_0"),
                  furthest > 0.0 ? 1.05 * furthest : 1.0,
                  top > 0.0 && top <= 1.0 ? 1.05 * top : 1.05, plot_of(plots));
  figure.data = table.text();
  return figure;
}

namespace {

/// Returns " Fitted: fem 2.28 ± 0.06."; empty without a fit.
std::string fitted_kappas(std::span<const Series> series) {
  std::string limits;
  for (const Series& one : series)
    if (quantity(one, "kappa").has_value())
      limits += fmt::format("{}{} {}", limits.empty() ? " Fitted: " : ", ",
                            one.label, number_text(quantity(one, "kappa")));
  return limits.empty() ? limits : limits + ".";
}

} // namespace

Figure area_coefficient_figure(std::span<const Series> series) {
  Figure figure;
  figure.name = "area-coefficient";
  figure.title = "Area-load coefficient κ";
  CsvTable table({"curve", "index", "A/A_0 counted [1]",
                  "A E* h'/(A_0 p) counted [1]", "A/A_0 corrected [1]",
                  "A E* h'/(A_0 p) corrected [1]"});
  std::vector<std::string> plots;
  const std::string file = "'area-coefficient.csv' ";
  double lowest = 0.8;  // the axis: Persson's and Bush's values, and all data
  double highest = 3.2; // up to twice these
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (const SeriesRow& row : one.rows)
      if (row.area > 0.0)
        table.add(one.label, {static_cast<double>(i), row.area,
                              row.area / row.pressure_slope, row.area_corrected,
                              row.area_corrected / row.pressure_slope});
    for (const SeriesRow& row : one.rows)
      for (const double area : {row.area, row.area_corrected})
        if (const double kappa = area / row.pressure_slope; kappa > 0.0) {
          lowest = std::min(lowest, 0.9 * kappa);
          highest = std::max(highest, std::min(1.05 * kappa, 6.4));
        }
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
  figure.caption =
      "Markers: counted; coloured lines: corrected. κ is the value at A/A₀ = 0 "
      "of the line through the load steps with A/A₀ ≤ 15 %.";
  figure.caption += fitted_kappas(series) +
                    " Dotted: √(8/π) of Persson and √(2π) of Bush, Gibson and "
                    "Thomas." +
                    joined_words(series);
  for (const double theory :
       {std::sqrt(8.0 / std::numbers::pi), std::sqrt(2.0 * std::numbers::pi)})
    plots.push_back(fmt::format("{:.9g} with lines linewidth 0.8 dashtype 3 "
                                "linecolor rgb '#777777' notitle",
                                theory));
  figure.script =
      "set xlabel " + gnuplot_markup("A / A_0") + "\nset ylabel " +
      gnuplot_markup("A E* h' / (A_0 p)") +
      fmt::format("\nset xrange [0:1]\nset yrange [{:.4g}:{:.4g}]\n", lowest,
                  highest) +
      plot_of(plots);
  figure.data = table.text();
  return figure;
}

namespace {

// Describes the excess of the methods that have it, for example
// "fem counted +22 %, by (21) +15 %".
std::string excess_words(std::span<const Series> series) {
  std::string words;
  for (const Series& one : series) {
    const Estimate& counted = quantity(one, "area_excess");
    const Estimate& fitted = quantity(one, "area_excess_fit");
    if (!one.is_drawn || !counted.has_value())
      continue;
    words += fmt::format("{}{} counted {:+.0f} %", words.empty() ? "" : "; ",
                         one.label, Shown{100.0 * counted.value});
    if (fitted.has_value())
      words +=
          fmt::format(", by Eq. (21) {:+.0f} %", Shown{100.0 * fitted.value});
  }
  return words.empty() ? "" : " Above the theory at light load: " + words + ".";
}

} // namespace

std::optional<Figure> area_theory_figure(std::span<const Series> series) {
  Figure figure;
  figure.name = "area-theory";
  figure.title = "Contact area against that of the theory";
  figure.width = 860;
  CsvTable table({"curve", "index", "A_theory/A_0 [1]", "A/A_0 corrected [1]",
                  "A/A_0 by (21) [1]", "A/A_theory corrected [1]",
                  "A/A_theory by (21) [1]"});
  std::vector<std::string> areas;
  std::vector<std::string> ratios;
  const std::string file = "'area-theory.csv' ";
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    bool has_rows = false;
    for (const SeriesRow& row : one.rows) {
      if (one.is_theory() || !(row.theory_area > 0.0))
        continue;
      table.add(one.label,
                {static_cast<double>(i), row.theory_area, row.area_corrected,
                 row.area_fit, row.area_corrected / row.theory_area,
                 row.area_fit / row.theory_area});
      has_rows = true;
    }
    if (!has_rows || !one.is_drawn)
      continue;
    const std::string line = " with lines " + line_style(one) + " notitle";
    const std::string points = " with points " + point_style(one);
    areas.push_back(file + of_series(i, "$3:4") + line);
    areas.push_back(file + of_series(i, "$3:5") + points + " title " +
                    gnuplot_text(one.legend));
    ratios.push_back(file + of_series(i, "$3:6") + line);
    ratios.push_back(file + of_series(i, "$3:7") + points + " notitle");
  }
  if (areas.empty())
    return std::nullopt;
  const std::string dotted =
      " with lines linewidth 0.8 dashtype 3 linecolor rgb '#777777' notitle";
  areas.push_back("x" + dotted);
  ratios.push_back("1" + dotted);
  figure.caption =
      "Each method's area against the theory's at the same load (left), and "
      "the ratio of the two (right). Markers: the area by Eq. (21) of Yang and "
      "Persson (2008), from the fitted pressure distribution; lines: the "
      "method's best estimate. Dotted: equal areas." +
      excess_words(series) + joined_words(series);
  figure.script = fmt::format(
      "set multiplot layout 1,2 margins 0.086,0.985,0.205,0.96 spacing 0.09\n"
      "set key at screen 0.5, 0.02 bottom center vertical maxrows 1\nset "
      "xlabel {0}\nset ylabel {1}\nset xrange [0:1]\n"
      "set yrange [0:1]\n{2}unset key\nset ylabel {3}\nset logscale x\n"
      "set xrange [*:1]\nset yrange [*:*]\nset offsets 0, 0, 0.05, 0.05\n{4}"
      "unset multiplot\n",
      gnuplot_markup("A_{theory} / A_0"), gnuplot_markup("A / A_0"),
      plot_of(areas), gnuplot_markup("A / A_{theory}"), plot_of(ratios));
  figure.data = table.text();
  return figure;
}

} // namespace asperity::reports
