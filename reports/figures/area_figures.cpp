#include "base/shown_number.hpp"
#include "base/special_numbers.hpp"
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
      "Symbols: the contact area at each load, corrected for the grid where "
      "the "
      "method does so. Dotted in the same colour: counted node by node.";
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

/// The axes of contact area against nominal pressure.
ChartPanel area_panel(std::span<const Series> series,
                      const FigureScales& scales) {
  double furthest = 0.0, top = 0.0, least = infinity;
  std::vector<double> loads;
  for (const Series& one : series)
    for (const SeriesRow& row :
         one.rows.size() == 1 ? one.line_rows() : one.rows) {
      loads.push_back(row.pressure);
      furthest = std::max(furthest, row.pressure);
      top = std::max({top, row.area, row.area_corrected});
      if (row.area_corrected > 0.0)
        least = std::min(least, row.area_corrected);
    }
  ChartPanel panel{.x = load_axis(series, scales),
                   .y = area_axis(scales, std::min(top, 1.0))};
  panel.x.is_log = panel.x.has_powers = is_spaced_logarithmically(loads);
  panel.y.is_log = panel.y.has_powers = panel.x.is_log && top > 30.0 * least;
  if (!panel.x.is_log) {
    panel.x.low = 0.0;
    panel.x.high = rounded(furthest > 0.0 ? 1.05 * furthest : 1.0, 6);
  }
  if (!panel.y.is_log) {
    panel.y.low = 0.0;
    panel.y.high = rounded(top > 0.0 && top <= 1.0 ? 1.05 * top : 1.05, 4);
  }
  return panel;
}

Figure area_figure(std::span<const Series> series, const FigureScales& scales) {
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
  ChartPanel panel = area_panel(series, scales);
  const auto scaled = [&](const Series& one, const SeriesRow& row) {
    return &one == theory && scale * row.area <= 1.0 ? scale * row.area
                                                     : not_a_number;
  };
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (const SeriesRow& row : one.line_rows())
      table.add(one.label, {static_cast<double>(i), row.pressure, row.area,
                            row.area_corrected, scaled(one, row)});
    if (one.rows.empty() || !one.is_drawn)
      continue;
    if (one.is_theory()) {
      panel.add(one.legend, line_style(one), i, 3, 4);
      if (&one == theory && std::isfinite(scale))
        panel.add(fmt::format("{} × {:.3g}", one.label, scale),
                  line("#222222", 1.2, 2), i, 3, 6);
      continue;
    }
    panel.add(one.legend, point_style(one), i, 3, 5);
    panel.add("", line(series_color(one), 1.0, 3), i, 3, 4);
    add_area_band(panel, one.rows, series_color(one));
  }
  if (panel.curves.empty())
    figure.problem = "no load step with a pressure above 0 converged";
  figure.caption = area_caption(fitted) + joined_words(series);
  if (!panel.bands.empty())
    figure.caption += " Bands: 95 % interval of the mean area over the "
                      "realisations.";
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

/// Returns " Fitted: fem 2.28 ± 0.06."; empty without a fit.
std::string fitted_kappas(std::span<const Series> series) {
  std::string limits;
  for (const Series& one : series)
    if (quantity(one, "kappa").has_value())
      limits += fmt::format("{}{} {}", limits.empty() ? " Fitted: " : ", ",
                            one.label, number_text(quantity(one, "kappa")));
  return limits.empty() ? limits : limits + ".";
}

/// Whether a method has more than one load, so that a curve is seen.
bool has_several_loads(std::span<const Series> series) {
  return std::ranges::any_of(series, [](const Series& one) {
    return !one.is_theory() && one.rows.size() > 1;
  });
}

std::optional<Figure> area_coefficient_figure(std::span<const Series> series) {
  constexpr double end_of_axis = 6.4; // twice these values
  if (!has_several_loads(series))
    return std::nullopt;
  Figure figure;
  figure.name = "area-coefficient";
  figure.title = "Area-load coefficient κ";
  CsvTable table({"curve", "index", "A/A_0 counted [1]",
                  "A E* h'/(A_0 p) counted [1]", "A/A_0 corrected [1]",
                  "A E* h'/(A_0 p) corrected [1]"});
  ChartPanel panel{.x = {.label = "A / A_0", .low = 0.0, .high = 1.0},
                   .y = {.label = "A E* h' / (A_0 p)"}};
  double lowest = 0.8; // the axis: Persson's and Bush's values, and all data
  double highest = 3.2;
  bool has_more = false;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (const SeriesRow& row : one.line_rows())
      if (row.area > 0.0)
        table.add(one.label, {static_cast<double>(i), row.area,
                              row.area / row.pressure_slope, row.area_corrected,
                              row.area_corrected / row.pressure_slope});
    for (const SeriesRow& row : one.rows)
      for (const double area : {row.area, row.area_corrected})
        if (const double kappa = area / row.pressure_slope; kappa > 0.0) {
          lowest = std::min(lowest, 0.9 * kappa);
          highest = std::max(highest, std::min(1.05 * kappa, end_of_axis));
          has_more = has_more || kappa > end_of_axis;
        }
    if (one.rows.empty() || !one.is_drawn)
      continue;
    if (one.is_theory()) {
      panel.add(one.label, line_style(one), i, 3, 4);
      continue;
    }
    panel.add(one.legend, point_style(one), i, 5, 6);
    panel.add("", line(series_color(one), 1.0, 3), i, 3, 4);
  }
  figure.caption = "Symbols: corrected; dotted in the same colour: counted. κ "
                   "is the value at A/A₀ = 0 "
                   "of the line through the load steps with A/A₀ ≤ 15 %.";
  figure.caption +=
      fitted_kappas(series) +
      " Dotted levels: √(8/π) of Persson and √(2π) of Bush, Gibson and "
      "Thomas." +
      (has_more ? " Larger values are above the axis." : "") +
      joined_words(series);
  for (const double theory :
       {std::sqrt(8.0 / std::numbers::pi), std::sqrt(2.0 * std::numbers::pi)})
    panel.curves.push_back(level(rounded(theory, 9), line("#777777", 0.8, 3)));
  panel.y.low = rounded(lowest, 4);
  panel.y.high = rounded(highest, 4);
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

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

std::optional<Figure> area_theory_figure(std::span<const Series> series) {
  if (!has_several_loads(series))
    return std::nullopt;
  Figure figure;
  figure.name = "area-theory";
  figure.title = "Contact area against that of the theory";
  figure.width = 860;
  CsvTable table({"curve", "index", "A_theory/A_0 [1]", "A/A_0 corrected [1]",
                  "A/A_0 by (21) [1]", "A/A_theory corrected [1]",
                  "A/A_theory by (21) [1]"});
  const ChartAxis theory_axis{.label = "A_{theory} / A_0", .high = 1.0};
  ChartPanel areas{.x = theory_axis,
                   .y = {.label = "A / A_0", .low = 0.0, .high = 1.0}};
  areas.x.low = 0.0;
  ChartPanel ratios{.x = theory_axis,
                    .y = {.label = "A / A_{theory}"},
                    .offsets = "0, 0, 0.05, 0.05"};
  ratios.x.is_log = true;
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
    areas.add("", line(series_color(one), 1.0, 3), i, 3, 5);
    areas.add(one.legend, point_style(one), i, 3, 4);
    ratios.add("", line(series_color(one), 1.0, 3), i, 3, 7);
    ratios.add("", point_style(one), i, 3, 6);
  }
  if (areas.curves.empty())
    return std::nullopt;
  const CurveStyle dotted = line("#777777", 0.8, 3);
  areas.curves.push_back({.style = dotted, .slope = 1.0});
  ratios.curves.push_back(level(1.0, dotted));
  figure.caption =
      "Each method's area against the theory's at the same load (left), and "
      "the ratio of the two (right). Symbols: the method's best estimate; "
      "dotted "
      "in the same colour: the area by Eq. (21) of Yang and Persson (2008), "
      "from the fitted pressure distribution. Grey: equal areas." +
      excess_words(series) + joined_words(series);
  figure.panels = {std::move(areas), std::move(ratios)};
  figure.grid = side_by_side(0.205);
  figure.data = table.text();
  return figure;
}

} // namespace

const ReportFigure figures::area_pressure{.names = {"area-pressure"},
                                          .section = FigureSection::curves,
                                          .draw = drawn_by<area_figure>,
                                          .applies = has_rough_contact};

const ReportFigure figures::area_coefficient{
    .names = {"area-coefficient"},
    .section = FigureSection::curves,
    .draw = drawn_by<area_coefficient_figure>,
    .applies = has_rough_contact};

const ReportFigure figures::area_theory{.names = {"area-theory"},
                                        .section = FigureSection::curves,
                                        .draw = drawn_by<area_theory_figure>,
                                        .applies = has_rough_contact};

} // namespace asperity::reports
