#include "reports/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

// "using" clause for one series: rows of another have no x and are not drawn.
std::string of_series(std::size_t index, const std::string& columns) {
  const std::size_t x_end = columns.find(':');
  return fmt::format("using ($2=={} ? {} : NaN):{}", index,
                     columns.substr(0, x_end), columns.substr(x_end + 1));
}

std::string join(const std::vector<std::string>& parts) {
  std::string text = "plot ";
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : ", \\\n  ") + parts[i];
  return text + "\n";
}

const Estimate& quantity(const Series& series, const std::string& name) {
  static const Estimate none;
  const auto found = series.method->quantities.find(name);
  return found == series.method->quantities.end() ? none : found->second;
}

const Series* first_numerical(std::span<const Series> series) {
  for (const Series& one : series)
    if (!one.is_theory() && !one.rows.empty())
      return &one;
  return nullptr;
}

const Series* theory_of(std::span<const Series> series, const Series& method) {
  for (const Series& one : series)
    if (one.is_theory() && one.entry == method.entry && !one.rows.empty())
      return &one;
  return nullptr;
}

std::string with_interval(const Estimate& estimate) {
  return estimate.has_interval()
             ? fmt::format("{:.3g} ± {:.1g}", estimate.value,
                           estimate.half_width)
             : fmt::format("{:.3g}", estimate.value);
}

// The next of 1, 2, 5 times a power of ten at or above `step`.
double round_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= step)
      return digit * power;
  return 10.0 * power;
}

// Bars at the foot of the plot: each method's fit window, mean over its
// realisations.
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
    if (count == 0)
      continue;
    script += fmt::format(
        "set arrow from {0:.6g}, graph {2:.3f} to {1:.6g}, graph {2:.3f} "
        "nohead linewidth 2.5 linecolor rgb '{3}'\n",
        low / count, high / count, 0.02 + 0.022 * bars++,
        one.is_theory() ? "#222222" : method_color(one.color));
  }
  return script;
}

// Adds the fitted exponential of `series` as rows of its own.
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

} // namespace

Figure pressure_gap_figure(std::span<const ReportEntry> entries,
                           std::span<const Series> series) {
  Figure figure;
  figure.name = "pressure-gap";
  figure.title = "Pressure against separation";
  CsvTable table({"curve", "index", "p/E* [1]", "log10 p/E* [1]", "u/h_rms [1]",
                  "least u/h_rms [1]", "largest u/h_rms [1]"});
  std::vector<std::string> plots;
  const std::string file = "'pressure-gap.csv' ";
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    for (const SeriesRow& row : one.rows)
      table.add(one.label,
                {static_cast<double>(i), row.pressure, std::log10(row.pressure),
                 row.gap, row.gap_low, row.gap_high});
    const std::string title = " title " + gnuplot_text(one.label);
    if (one.rows.empty())
      continue;
    if (one.is_theory())
      plots.push_back(file + of_series(i, "$5:4") + " with lines " +
                      line_style(one) + title);
    else
      plots.push_back(file + of_series(i, "$5:4:6:7") + " with xerrorbars " +
                      point_style(one) + title);
  }
  figure.caption =
      "Each sign is a load step, the mean of the realisations; its "
      "bar spans them.";
  const Series* fitted = first_numerical(series);
  if (fitted != nullptr && quantity(*fitted, "gamma_slope").has_value()) {
    const std::size_t index = series.size();
    add_fit(table, index, *fitted);
    const Estimate& gamma = quantity(*fitted, "gamma_slope");
    plots.push_back(
        file + of_series(index, "$5:4") +
        " with lines linewidth 0.9 dashtype 3 linecolor rgb '#777777' title " +
        gnuplot_markup(
            fmt::format("fit, u_0/h_{{rms}} = {}", with_interval(gamma))));
    figure.caption += fmt::format(
        " The dotted line is p = β E* exp(−u/u₀) with u₀/h_rms = {} from {}; "
        "the bars at the foot show the window of each method's fit.",
        with_interval(gamma), fitted->label);
  }
  figure.script =
      "set xlabel " + gnuplot_markup("mean separation u / h_{rms}") +
      "\nset ylabel " + gnuplot_markup("log_{10}  p / E*") +
      "\nset key top right\nset xrange [0:*]\n" + window_bars(series);
  if (entries.size() == 1 && !entries.front().summary.methods.empty() &&
      !entries.front().summary.methods.back().fits.empty()) {
    const double height_nm =
        entries.front().summary.methods.back().fits.front().scales.rms_height *
        1e9;
    double furthest = 0.0;
    for (const Series& one : series)
      for (const SeriesRow& row : one.rows)
        furthest = std::max(furthest, row.gap);
    figure.script += fmt::format(
        "set link x2 via x*{0:.9g} inverse x/{0:.9g}\nset x2tics 0,{1:g}\nset "
        "border 7\nset x2label 'u [nm]'\n",
        height_nm, round_step(furthest * height_nm / 4.0));
  }
  figure.script += join(plots);
  figure.data = table.text();
  return figure;
}

std::optional<Figure> gap_deviation_figure(std::span<const Series> series) {
  Figure figure;
  figure.name = "gap-deviation";
  figure.title = "How far each method is from the theory";
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
    if (!has_rows)
      continue;
    plots.push_back("'gap-deviation.csv' " + of_series(i, "$3:4") +
                    " with linespoints " + point_style(one) + " title " +
                    gnuplot_text(one.label));
  }
  if (plots.size() == 1)
    return std::nullopt;
  figure.caption = fmt::format(
      "Separation at equal pressure, minus the theory's, in per cent of h_rms; "
      "at most {:.2g} % for the mean of the realisations. The shaded range, "
      "0.3 < u/h_rms < 1.5, is the one that gap_deviation looks at.",
      largest);
  figure.script =
      "set xlabel " + gnuplot_markup("mean separation u / h_{rms}") +
      "\nset ylabel " + gnuplot_markup("(u − u_{theory}) / h_{rms}  [%]") +
      "\nset key top right\nset xrange [0:*]\nset offsets graph 0, 0, 0.3, "
      "0.1\nset object 1 rectangle from 0.3, "
      "graph 0 to 1.5, graph 1 behind fillcolor rgb '#0072B2' fillstyle solid "
      "0.06 noborder\n" +
      join(plots);
  figure.data = table.text();
  return figure;
}

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
    if (one.rows.empty())
      continue;
    const std::string title = gnuplot_text(one.label);
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
                    point_style(one) + " title " +
                    gnuplot_text(one.label + ", counted"));
    plots.push_back(file + of_series(i, "$3:5") + " with lines " +
                    line_style(one) + " title " +
                    gnuplot_text(one.label + ", corrected"));
  }
  figure.caption = "Signs: contact counted node by node. Coloured lines: the "
                   "same with the area at the contact's rim corrected.";
  if (fitted != nullptr && quantity(*fitted, "area_excess").has_value())
    figure.caption += fmt::format(
        " Counted, {} has {:+.0f} % of contact against the theory at light "
        "load.",
        fitted->label, 100.0 * quantity(*fitted, "area_excess").value);
  if (std::isfinite(scale))
    figure.caption +=
        fmt::format(" Dashed: the theory scaled by {:.3g} to {}'s fitted κ.",
                    scale, fitted->label);
  figure.script = fmt::format(
      "set xlabel {}\nset ylabel {}\nset key top left\nset xrange "
      "[0:{:.6g}]\nset yrange [0:{}]\n{}",
      gnuplot_markup("p / E*"), gnuplot_markup("A / A_0"),
      furthest > 0.0 ? 1.1 * furthest : 1.0, 1.2 * largest_area, join(plots));
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
    if (one.rows.empty())
      continue;
    if (one.is_theory()) {
      plots.push_back(file + of_series(i, "$3:4") + " with lines " +
                      line_style(one) + " title " + gnuplot_text(one.label));
      continue;
    }
    plots.push_back(file + of_series(i, "$3:4") + " with points " +
                    point_style(one) + " title " +
                    gnuplot_text(one.label + ", counted"));
    plots.push_back(file + of_series(i, "$5:6") + " with lines " +
                    line_style(one) + " title " +
                    gnuplot_text(one.label + ", corrected"));
  }
  figure.caption = "κ is where a curve meets the left edge, on a line through "
                   "its rows with A/A₀ ≤ 15 %.";
  std::string limits;
  for (const Series& one : series)
    if (quantity(one, "kappa").has_value())
      limits += fmt::format("{}{} {}", limits.empty() ? " Fitted: " : ", ",
                            one.label, with_interval(quantity(one, "kappa")));
  if (!limits.empty())
    figure.caption += limits + ".";
  figure.caption += " Dotted: √(8/π) of Persson and √(2π) of Bush, Gibson and "
                    "Thomas.";
  plots.push_back("sqrt(8/pi) with lines linewidth 0.8 dashtype 3 linecolor "
                  "rgb '#777777' notitle");
  plots.push_back("sqrt(2*pi) with lines linewidth 0.8 dashtype 3 linecolor "
                  "rgb '#777777' notitle");
  figure.script =
      "set xlabel " + gnuplot_markup("A / A_0") + "\nset ylabel " +
      gnuplot_markup("A E* h' / (A_0 p)") +
      "\nset key top right\nset xrange [0:1]\nset yrange [0.8:3.2]\n" +
      join(plots);
  figure.data = table.text();
  return figure;
}

std::optional<Figure> cost_figure(std::span<const Series> series) {
  Figure figure;
  figure.name = "cost";
  figure.title = "What each step cost";
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
        fmt::format("{}{}: {:.2g} s a step (median), at most {} iterations",
                    figure.caption.empty() ? "" : "; ", one.label,
                    cost.step_cpu_time, cost.largest_iterations);
  }
  if (iterations.empty())
    return std::nullopt;
  figure.caption += ". CPU time, mean of the realisations.";
  figure.script = "set multiplot layout 1,2\nset logscale x\nset format x "
                  "'10^{%T}'\nset xlabel " +
                  gnuplot_markup("p / E*") +
                  "\nset ylabel 'iterations'\nset yrange [0:*]\nset key top "
                  "left\n" +
                  join(iterations) +
                  "unset yrange\nset ylabel 'CPU time a step [s]'\nset yrange "
                  "[0:*]\nunset key\n" +
                  join(times) + "unset multiplot\n";
  figure.data = table.text();
  return figure;
}

} // namespace asperity::reports
