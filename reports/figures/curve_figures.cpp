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
std::string window_bars(std::span<const Series> series) {
  std::string script;
  int bars = 0;
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
    script += fmt::format(
        "set arrow from {0:.6g}, graph {2:.3f} to {1:.6g}, graph {2:.3f} "
        "nohead linewidth 2.5 linecolor rgb '{3}'\n",
        low / count, high / count, 0.02 + 0.022 * bars++,
        one.is_theory() ? "#222222" : method_color(one.color));
  }
  return script;
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
    table.add("fit to " + series.label, {static_cast<double>(index), pressure,
                                         std::log10(pressure), gap, gap, gap});
  }
}

/// The axis starts at zero separation, or at the lowest (negative) gap where a
/// penalty method allows penetration.
std::string gap_range(std::span<const Series> series) {
  double lowest = 0.0;
  for (const Series& one : series)
    for (const SeriesRow& row : one.rows)
      lowest = std::min(lowest, row.gap_low);
  return fmt::format("\nset xrange [{:.4g}:*]", 1.1 * lowest);
}

/// Adds the rows of all series to the table of pressure-gap.csv.
/// @return  the plots of those that are drawn
std::vector<std::string> add_gap_curves(std::span<const Series> series,
                                        const std::string& file,
                                        CsvTable& table, Bands& bands) {
  std::vector<std::string> plots;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (const SeriesRow& row : one.rows)
      table.add(one.label,
                {static_cast<double>(i), row.pressure, std::log10(row.pressure),
                 row.gap, row.gap_low, row.gap_high});
    const std::string title = " title " + gnuplot_text(one.legend);
    if (one.rows.empty() || !one.is_drawn)
      continue;
    if (one.is_theory())
      plots.push_back(file + of_series(i, "$5:4") + " with lines " +
                      line_style(one) + title);
    else {
      plots.push_back(file + of_series(i, "$5:4:6:7") + " with xerrorbars " +
                      point_style(one) + title);
      bands.add(gap_band(one.rows), series_color(one));
    }
  }
  return plots;
}

/// Returns the second x axis of a figure of one case, the gap in nm; "" if the
/// figure has no length scale.
std::string nanometre_axis(std::span<const ReportEntry> entries,
                           std::span<const Series> series) {
  if (entries.size() != 1 || entries.front().summary.methods.empty() ||
      entries.front().summary.methods.back().fits.empty())
    return "";
  const double height_nm =
      entries.front().summary.methods.back().fits.front().scales.rms_height *
      1e9;
  double furthest = 0.0;
  for (const Series& one : series)
    for (const SeriesRow& row : one.rows)
      furthest = std::max(furthest, row.gap);
  if (!(furthest > 0.0))
    return "";
  return fmt::format(
      "set link x2 via x*{0:.9g} inverse x/{0:.9g}\nset x2tics 0,{1:g}\n"
      "set border 7\nset x2label 'u [nm]'\n",
      height_nm, round_step(furthest * height_nm / 4.0));
}

} // namespace

Figure pressure_gap_figure(std::span<const ReportEntry> entries,
                           std::span<const Series> series) {
  Figure figure;
  figure.name = "pressure-gap";
  figure.title = "Pressure against separation";
  CsvTable table({"curve", "index", "p/E* [1]", "log10 p/E* [1]", "u/h_rms [1]",
                  "least u/h_rms [1]", "largest u/h_rms [1]"});
  const std::string file = "'pressure-gap.csv' ";
  Bands bands;
  std::vector<std::string> plots = add_gap_curves(series, file, table, bands);
  bands.add_to(figure, plots);
  figure.caption = "Each marker is a load step, the mean over the "
                   "realisations; its bar spans their range.";
  if (!bands.empty())
    figure.caption += " Bands: 95 % interval of the mean.";
  const Series* fitted = first_numerical(series);
  if (fitted != nullptr && quantity(*fitted, "gamma_slope").has_value() &&
      quantity(*fitted, "beta").has_value()) {
    const std::size_t index = series.size();
    add_fit(table, index, *fitted);
    const Estimate& gamma = quantity(*fitted, "gamma_slope");
    plots.push_back(
        file + of_series(index, "$5:4") +
        " with lines linewidth 0.9 dashtype 3 linecolor rgb '#777777' title " +
        gnuplot_text("fit to " + fitted->label));
    figure.caption += fmt::format(
        " The dotted line is p = β E* exp(−u/u₀) with u₀/h_rms = {} from {}; "
        "the bars at the bottom axis show the window of each method's fit.",
        number_text(gamma), fitted->label);
  }
  figure.caption += joined_words(series);
  figure.script =
      "set xlabel " + gnuplot_markup("mean separation u / h_{rms}") +
      "\nset ylabel " + gnuplot_markup("log_{10}  p / E*") + gap_range(series) +
      "\nset offsets 0, 0, 0, graph 0.1\n" + window_bars(series);
  figure.script += nanometre_axis(entries, series);
  if (plots.empty())
    figure.problem = "no load step converged";
  figure.script += plot_of(plots);
  figure.data = table.text();
  return figure;
}

std::optional<Figure> gap_deviation_figure(std::span<const Series> series) {
  Figure figure;
  figure.name = "gap-deviation";
  figure.title = "Deviation of each method from the theory";
  CsvTable table({"curve", "index", "u/h_rms [1]", "(u - u_theory)/h_rms [%]"});
  std::vector<std::string> plots{
      "0 with lines linewidth 1.2 linecolor rgb '#222222' title 'theory'"};
  double largest = 0.0;
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    bool has_rows = false;
    for (const SeriesRow& row : one.rows) {
      if (one.is_theory() || !std::isfinite(row.theory_gap))
        continue;
      const double percent = 100.0 * (row.gap - row.theory_gap);
      table.add(one.label, {static_cast<double>(i), row.gap, percent});
      largest = std::max(largest, std::abs(percent));
      has_rows = true;
    }
    if (!has_rows || !one.is_drawn)
      continue;
    plots.push_back("'gap-deviation.csv' " + of_series(i, "$3:4") +
                    " with linespoints " + point_style(one) + " title " +
                    gnuplot_text(one.legend));
  }
  if (plots.size() == 1)
    return std::nullopt;
  figure.caption = fmt::format(
      "Separation at equal pressure, minus the theory's, in per cent of h_rms; "
      "at most {:.2g} % for the mean over the realisations. The shaded range, "
      "0.3 < u/h_rms < 1.5, is the one that gap_deviation evaluates.",
      largest);
  figure.caption += joined_words(series);
  figure.script =
      "set xlabel " + gnuplot_markup("mean separation u / h_{rms}") +
      "\nset ylabel " + gnuplot_markup("(u − u_{theory}) / h_{rms}  [%]") +
      gap_range(series) +
      "\nset offsets graph 0, 0, 0.3, 0.1\nset object 1 rectangle from 0.3, "
      "graph 0 to 1.5, graph 1 behind fillcolor rgb '#0072B2' fillstyle solid "
      "0.06 noborder\n" +
      plot_of(plots);
  figure.data = table.text();
  return figure;
}

} // namespace asperity::reports
