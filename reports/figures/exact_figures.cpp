#include "reports/analysis/exact.hpp"
#include "reports/figures/figures.hpp"
#include "reports/figures/plot_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

struct Range {
  double low = 0.0;
  double high = 0.0;
};

Range pressures_of(std::span<const Series> series) {
  Range range{INFINITY, 0.0};
  for (const Series& one : series)
    for (const SeriesRow& row : one.rows) {
      range.low = std::min(range.low, row.pressure);
      range.high = std::max(range.high, row.pressure);
    }
  return range;
}

// One plot of one quantity against p/E*: the methods as markers, the exact
// solution as a line.
struct Curves {
  std::string name;
  std::string title;
  std::string axis;   // markup
  std::string column; // includes its unit
  std::string caption;
  double (*of_row)(const SeriesRow&);
  double (*of_exact)(const ExactPoint&);
  double unit = 1.0; // of the exact value
};

Figure curves_figure(const ReportEntry& entry, std::span<const Series> series,
                     const Curves& curves) {
  const FigureScales scales = figure_scales(std::span(&entry, 1));
  Figure figure;
  figure.name = curves.name;
  figure.title = curves.title;
  figure.caption = curves.caption;
  CsvTable table({"curve", "index", "p/E* [1]", curves.column});
  const double modulus = entry.result->contact_modulus;
  const double top = entry.result->surfaces.empty()
                         ? not_a_number
                         : entry.result->surfaces.front().highest;
  const auto computed = std::ranges::find_if(
      entry.result->methods, [](const results::MethodRecord& method) {
        return method.kind != "theory";
      });
  const bool is_free = computed != entry.result->methods.end() &&
                       has_free_boundaries(*entry.contact_case, *computed);
  const Range range = pressures_of(series);
  for (int k = 0; k <= 300; ++k) {
    const double pressure =
        range.low * std::pow(range.high / range.low, k / 300.0);
    const ExactPoint exact = exact_point(entry.contact_case->surface, modulus,
                                         pressure * modulus, top, is_free);
    table.add("exact", {0.0, pressure, curves.of_exact(exact) / curves.unit});
  }
  ChartPanel panel{
      .x = load_axis(series, scales),
      .y = curves.unit == 1.0
               ? area_axis(scales, 1.0)
               : length_axis(curves.axis, "mean gap u", scales.rms_height, 1.0),
      .curves = {curve("exact", line("#222222", 1.5), 0, 3, 4)}};
  panel.x.low = 0.0;
  panel.x.tick_step = round_step(range.high / 6.0);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const Series& one = series[i];
    if (one.is_theory() || one.rows.empty())
      continue;
    for (const SeriesRow& row : one.rows)
      table.add(one.label,
                {static_cast<double>(i + 1), row.pressure, curves.of_row(row)});
    if (!one.is_drawn)
      continue;
    panel.add(one.legend, point_style(one), i + 1, 3, 4);
  }
  figure.panels = {std::move(panel)};
  figure.caption += joined_words(series);
  figure.data = table.text();
  return figure;
}

std::string error_words(const ReportEntry& entry, const std::string& quantity) {
  std::string words;
  for (const MethodSummary& method : entry.summary.methods)
    if (const Estimate* const found = method.quantity(quantity);
        found != nullptr && found->has_value())
      words += fmt::format("{}{} {:.2g}", words.empty() ? "" : ", ",
                           method.name, found->value);
  return words;
}

std::vector<Figure> exact_figures(const ReportEntry& entry) {
  const std::vector<Series> series = series_of(std::span(&entry, 1));
  std::vector<Figure> figures;
  if (!(pressures_of(series).high > 0.0))
    return figures;
  const std::string area_errors = error_words(entry, "area_error");
  figures.push_back(curves_figure(
      entry, series,
      {"exact-area", "Contact fraction against the exact solution", "A / A_0",
       "A/A_0 [1]",
       "The corrected area. Largest error: " +
           (area_errors.empty() ? "unknown" : area_errors) + ".",
       [](const SeriesRow& row) { return row.area_corrected; },
       [](const ExactPoint& exact) { return exact.area_fraction; }}));
  if (entry.contact_case->surface.is_indenter() ||
      entry.result->surfaces.empty())
    return figures;
  figures.push_back(curves_figure(
      entry, series,
      {"exact-gap", "Mean gap against the exact solution", "u / h_{rms}",
       "u/h_rms [1]",
       "Largest error in amplitudes: " + error_words(entry, "mean_gap_error") +
           ".",
       [](const SeriesRow& row) { return row.gap; },
       [](const ExactPoint& exact) { return exact.mean_gap; },
       entry.result->surfaces.front().rms_height}));
  return figures;
}

} // namespace

const ReportFigure figures::exact{.names = {"exact-area", "exact-gap"},
                                  .section = FigureSection::contact,
                                  .draw = drawn_by<exact_figures>,
                                  .applies = is_exact};

} // namespace asperity::reports
