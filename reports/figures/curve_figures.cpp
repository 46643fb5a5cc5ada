#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/numbers/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

// Draws one bar per method at the bottom axis: its fit window, averaged over
// its realisations.
std::vector<ChartMark> window_bars(std::span<const Series> series) {
  std::vector<ChartMark> bars;
  for (const Series& one : series) {
    double low = 0.0;
    double high = 0.0;
    int count = 0;
    for (const RealizationFits& fits : one.method->fits) {
      if (!fits.slope.reason.empty())
        continue;
      low += fits.slope.window.gap_low / fits.scales.rms_height;
      high += fits.slope.window.gap_high / fits.scales.rms_height;
      ++count;
    }
    if (count == 0 || !one.is_drawn)
      continue;
    bars.push_back(
        {.low = rounded(low / count, 6),
         .high = rounded(high / count, 6),
         .height = rounded(0.02 + 0.022 * static_cast<double>(bars.size()), 3),
         .color = series_color(one)});
  }
  return bars;
}

// Adds the fitted exponential of `series` as separate rows.
void add_fit(CsvTable& table, std::size_t index, const Series& series) {
  const double decay = quantity(series, "gamma_slope").value;
  const double prefactor = quantity(series, "beta").value;
  double furthest = 0.0;
  for (const SeriesRow& row : series.rows)
    furthest = std::max(furthest, row.gap);
  for (const double gap : {0.0, 1.05 * furthest}) {
    const double pressure = prefactor * std::exp(-gap / decay);
    table.add("fit to " + series.label,
              {static_cast<double>(index), pressure, gap, gap, gap});
  }
}

/// The axis starts at zero separation, or at the lowest (negative) gap where a
/// penalty method allows penetration.
ChartAxis gap_axis(std::span<const Series> series, const FigureScales& scales) {
  double lowest = 0.0, largest = 0.0;
  for (const Series& one : series)
    for (const SeriesRow& row : one.rows) {
      lowest = std::min(lowest, row.gap_low);
      largest = std::max(largest, row.gap_high);
    }
  ChartAxis axis = length_axis("mean separation u / h_{rms}",
                               "mean separation u", scales.rms_height, largest);
  axis.low = rounded(1.1 * lowest, 4);
  return axis;
}

/// Adds the rows of all series to the table, and the curves of those that are
/// drawn.
void add_gap_curves(std::span<const Series> series, CsvTable& table,
                    ChartPanel& panel) {
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (const SeriesRow& row : one.line_rows())
      table.add(one.label, {static_cast<double>(i), row.pressure, row.gap,
                            row.gap_low, row.gap_high});
    if (one.rows.empty() || !one.is_drawn)
      continue;
    ChartCurve& drawn = panel.add(
        one.legend, one.is_theory() ? line_style(one) : point_style(one), i, 4,
        3);
    if (one.is_theory())
      continue;
    drawn.low = 5;
    drawn.high = 6;
    drawn.has_x_interval = true;
    add_gap_band(panel, one.rows, series_color(one));
  }
}

Figure pressure_gap_figure(std::span<const Series> series,
                           const FigureScales& scales) {
  Figure figure;
  figure.name = "pressure-gap";
  figure.title = "Pressure against separation";
  CsvTable table({"curve", "index", "p/E* [1]", "u/h_rms [1]",
                  "least u/h_rms [1]", "largest u/h_rms [1]"});
  ChartPanel panel{.x = gap_axis(series, scales),
                   .y = load_axis(series, scales)};
  panel.y.is_log = panel.y.has_powers = true;
  add_gap_curves(series, table, panel);
  figure.caption = "Each marker is a load step, the mean over the "
                   "realisations; its bar spans their range.";
  if (!panel.bands.empty())
    figure.caption += " Bands: 95 % interval of the mean.";
  const Series* fitted = first_numerical(series);
  if (fitted != nullptr && quantity(*fitted, "gamma_slope").has_value() &&
      quantity(*fitted, "beta").has_value()) {
    const std::size_t index = series.size();
    add_fit(table, index, *fitted);
    panel.marks = window_bars(series);
    const Estimate& gamma = quantity(*fitted, "gamma_slope");
    panel.add("fit to " + fitted->label, line("#777777", 0.9, 3), index, 4, 3);
    figure.caption += fmt::format(
        " The dotted line is p = β E* exp(−u/u₀) with u₀/h_rms = {} from {}; "
        "the bars at the bottom axis show the window of each method's fit.",
        number_text(gamma), fitted->label);
  }
  figure.caption += joined_words(series);
  if (panel.curves.empty())
    figure.problem = "no load step with a pressure above 0 converged";
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

std::optional<Figure> gap_deviation_figure(std::span<const Series> series,
                                           const FigureScales& scales) {
  Figure figure;
  figure.name = "gap-deviation";
  figure.title = "Deviation of each method from the theory";
  CsvTable table({"curve", "index", "u/h_rms [1]", "(u - u_theory)/h_rms [%]"});
  ChartPanel panel{.x = gap_axis(series, scales),
                   .y = {.label = "(u − u_{theory}) / h_{rms}  [%]"},
                   .curves = {level(0.0, line("#222222", 1.2), "theory")},
                   .marks = {{.low = 0.3, .high = 1.5, .color = "#0072B2"}},
                   .offsets = "graph 0, 0, 0.3, 0.1"};
  double largest = 0.0;
  bool is_curve = false; // and not a point
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    bool has_rows = false;
    for (const SeriesRow& row : one.rows) {
      if (one.is_theory() || !std::isfinite(row.theory_gap))
        continue;
      is_curve = is_curve || has_rows;
      const double percent = 100.0 * (row.gap - row.theory_gap);
      table.add(one.label, {static_cast<double>(i), row.gap, percent});
      largest = std::max(largest, std::abs(percent));
      has_rows = true;
    }
    if (!has_rows || !one.is_drawn)
      continue;
    panel.add(one.legend, joined(point_style(one)), i, 3, 4);
  }
  if (panel.curves.size() == 1 || !is_curve)
    return std::nullopt;
  panel.y.other =
      length_axis("", "u − u_{theory}", 0.01 * scales.rms_height, largest)
          .other;
  figure.caption = fmt::format(
      "Separation at equal pressure, minus the theory's, in per cent of h_rms; "
      "at most {} % for the mean over the realisations. The shaded range, "
      "0.3 < u/h_rms < 1.5, is the one that gap_deviation evaluates.",
      digits_text(largest, 2));
  figure.caption += joined_words(series);
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

} // namespace

const ReportFigure figures::pressure_gap{.names = {"pressure-gap"},
                                         .section = FigureSection::curves,
                                         .draw = drawn_by<pressure_gap_figure>,
                                         .applies = has_rough_contact};

const ReportFigure figures::gap_deviation{.names = {"gap-deviation"},
                                          .section = FigureSection::curves,
                                          .draw =
                                              drawn_by<gap_deviation_figure>,
                                          .applies = has_rough_contact};

} // namespace asperity::reports
