// Quantities of a sweep against the swept keys: lines and heat maps.
#include "reports/analysis/claims.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/sweeps/sweep_axis.hpp"
#include "reports/sweeps/sweep_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>

namespace asperity::reports {
namespace {

constexpr std::size_t most_trends = 8;
constexpr std::size_t most_heat_maps = 8;
constexpr std::size_t most_lines = 24;

/// Quantities whose dependence on the swept keys is shown in the table only.
bool is_drawn_quantity(const std::string& name) {
  constexpr std::array<std::string_view, 3> others{"iterations_max",
                                                   "penetration", "epsilon"};
  return std::ranges::find(others, name) == others.end();
}

double value_at(const SweptResult& result, const std::string& method,
                const std::string& quantity_name) {
  const Estimate* const estimate =
      swept_estimate(result, method, quantity_name);
  return estimate == nullptr ? not_a_number : estimate->value;
}

/// True if the values of the method differ by more than 1e-3 of their size.
bool is_varied(const SweptResults& results, const std::string& method,
               const std::string& quantity_name) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto& result : results)
    if (const double value = value_at(*result, method, quantity_name);
        std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  return high - low > 1e-3 * std::max(std::abs(low), std::abs(high));
}

/// One line of a trend: a method, and the values of all keys but the first.
std::string line_of(const SweepRecord& record, std::size_t point,
                    const std::string& method) {
  std::string name = method;
  if (record.combine == cases::Combine::product)
    for (std::size_t k = 1; k < record.keys.size(); ++k)
      name += fmt::format(
          ", {}",
          axis_of(record.keys[k]).labels[record.points[point].choice[k]]);
  return name;
}

/// One line of a trend with its rows.
struct TrendLine {
  std::string name;
  std::size_t method = 0;  ///< index of its method, which gives its colour
  std::size_t variant = 0; ///< index among the lines of the method
  std::vector<std::vector<double>> rows; ///< position, value and its limits
};

/// Returns the lines of all methods. The rows of a line follow each other, in
/// the order of the first key.
std::vector<TrendLine> trend_lines(const SweepRecord& record,
                                   const SweptResults& results,
                                   const FigureAxis& axis,
                                   const std::string& quantity_name) {
  std::vector<TrendLine> lines;
  const std::vector<std::string> methods = swept_methods(results);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    std::size_t variants = 0;
    for (const auto& result : results) {
      const Estimate* const estimate =
          swept_estimate(*result, methods[m], quantity_name);
      if (estimate == nullptr || !estimate->has_value())
        continue;
      const std::string name = line_of(record, result->point, methods[m]);
      auto line = std::ranges::find(lines, name, &TrendLine::name);
      if (line == lines.end())
        line = lines.insert(lines.end(), {name, m, variants++, {}});
      const double half_width =
          estimate->has_interval() ? estimate->half_width : 0.0;
      line->rows.push_back(
          {axis.positions[record.points[result->point].choice[0]],
           estimate->value, estimate->value - half_width,
           estimate->value + half_width});
    }
  }
  return lines;
}

/// Draws lines over an axis, with their intervals.
Figure figure_of_lines(const std::string& quantity_name, const FigureAxis& axis,
                       const std::vector<TrendLine>& lines) {
  Figure figure;
  figure.name = "sweep-" + file_word(quantity_name);
  figure.title = quantity_name + " against " + axis.title;
  CsvTable table({"line", "index", axis.title, quantity_name,
                  "low end of 95 % interval", "high end of 95 % interval"});
  ChartPanel panel{.x = {.label = as_markup(axis.title), .is_log = axis.is_log},
                   .y = {.label = as_markup(quantity_name)},
                   .offsets = "graph 0.04, graph 0.04, graph 0.08, graph 0.08",
                   .has_narrow_legend = true};
  if (!axis.is_numeric)
    panel.x.ticks = named_ticks(axis);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const std::vector<double>& row : lines[i].rows)
      table.add(lines[i].name,
                {static_cast<double>(i), row[0], row[1], row[2], row[3]});
    const bool is_theory = lines[i].name.starts_with("theory");
    CurveStyle style = joined(
        markers(is_theory ? "#222222" : method_color(lines[i].method),
                5 + 2 * static_cast<int>(lines[i].method % 5), 0.7, 1.2));
    style.dash = 1 + static_cast<int>(lines[i].variant % 5);
    ChartCurve& drawn = panel.add(lines[i].name, style, i, 3, 4);
    drawn.low = 5;
    drawn.high = 6;
  }
  if (lines.size() > most_lines)
    figure.problem = fmt::format("it would have {} lines; the numbers are in "
                                 "sweep.csv",
                                 lines.size());
  figure.caption = "Bars: 95 % interval; where there is none, the point has "
                   "one realisation without an error of its own.";
  figure.panels = {std::move(panel)};
  figure.data = table.text();
  return figure;
}

Figure trend_figure(const SweepRecord& record, const SweptResults& results,
                    const std::string& quantity_name) {
  const FigureAxis axis = axis_of(record.keys[0]);
  const std::vector<TrendLine> lines =
      trend_lines(record, results, axis, quantity_name);
  Figure figure = figure_of_lines(quantity_name, axis, lines);
  figure.title = quantity_name + " against " + record.keys[0].key;
  if (const std::string meaning = meaning_of(quantity_name); !meaning.empty())
    figure.caption =
        fmt::format("{}: {} {}", quantity_name, meaning, figure.caption);
  return figure;
}

/// True for a zip that visits a value of its first key more than once, so that
/// its points lie on no line over this key.
bool returns_to_first_key(const SweepRecord& record) {
  const std::vector<std::string>& values = record.keys[0].values;
  return record.combine == cases::Combine::zip &&
         std::set<std::string>(values.begin(), values.end()).size() <
             values.size();
}

Figure heat_map(const SweepRecord& record, const SweptResults& results,
                const std::string& quantity_name, const std::string& method) {
  Figure figure;
  figure.name =
      file_word(fmt::format("sweep-map-{}-{}", method, quantity_name));
  figure.title = quantity_name + ": " + method;
  const FigureAxis across = axis_of(record.keys[0]);
  const FigureAxis up = axis_of(record.keys[1]);
  CsvTable table(
      {"cell", "x", "y", quantity_name, "half-width of 95 % interval"});
  ChartImage image{.x = 2,
                   .y = 3,
                   .value = 4,
                   .has_cells = true,
                   .colors = "cells",
                   .label = as_markup(quantity_name),
                   .proportions = Proportions::filling};
  for (const auto& result : results) {
    const Estimate* const estimate =
        swept_estimate(*result, method, quantity_name);
    if (estimate == nullptr || !estimate->has_value())
      continue;
    const std::vector<std::size_t>& choice =
        record.points[result->point].choice;
    table.add(record.label(result->point),
              {static_cast<double>(choice[0]), static_cast<double>(choice[1]),
               estimate->value, estimate->half_width});
    if (across.labels.size() <= 8)
      image.notes.push_back(
          {{static_cast<double>(choice[0]), static_cast<double>(choice[1])},
           fmt::format("{:.3g}", estimate->value)});
  }
  figure.caption = "One cell per point, coloured by the value of the method; "
                   "white: no value. The intervals are in the table.";
  const auto cells = [](const FigureAxis& axis, const std::string& key) {
    return ChartAxis{.label = as_markup(key),
                     .low = -0.5,
                     .high = static_cast<double>(axis.labels.size()) - 0.5,
                     .ticks = named_ticks(axis)};
  };
  figure.panels = {{.x = cells(across, record.keys[0].key),
                    .y = cells(up, record.keys[1].key),
                    .image = std::move(image)}};
  figure.data = table.text();
  return figure;
}

} // namespace

std::vector<Figure> sweep_trend_figures(const SweepRecord& record,
                                        const SweptResults& results) {
  std::vector<Figure> figures;
  if (returns_to_first_key(record))
    return figures;
  const std::vector<std::string> methods = swept_methods(results);
  for (const std::string& name : swept_quantities(results))
    if (figures.size() < most_trends && is_drawn_quantity(name) &&
        std::ranges::any_of(methods, [&](const std::string& method) {
          return is_varied(results, method, name);
        }))
      figures.push_back(trend_figure(record, results, name));
  return figures;
}

std::vector<Figure> sweep_limit_figures(const std::vector<SweepLimit>& limits) {
  std::vector<Figure> figures;
  const auto add = [&](const char* quantity, const std::string& title,
                       bool is_log, double SweepLimit::*position) {
    std::vector<TrendLine> lines;
    for (const SweepLimit& limit : limits) {
      const auto found = limit.limits.find(quantity);
      if (std::isnan(limit.*position) || found == limit.limits.end() ||
          !found->second.has_value())
        continue;
      const std::string name =
          fmt::format("{}, H = {:g}", limit.method, limit.hurst);
      if (lines.empty() || lines.back().name != name)
        lines.push_back({name, lines.size(), 0, {}});
      const Estimate& estimate = found->second;
      const double half_width =
          estimate.has_interval() ? estimate.half_width : 0.0;
      lines.back().rows.push_back({limit.*position, estimate.value,
                                   estimate.value - half_width,
                                   estimate.value + half_width});
    }
    if (lines.empty())
      return;
    const FigureAxis axis{title, {}, {}, true, is_log};
    figures.push_back(figure_of_lines(quantity, axis, lines));
    figures.back().name =
        file_word(fmt::format("limit-{}-{}", quantity, title));
    figures.back().title = fmt::format("{} in the limit", quantity);
    figures.back().caption = "Bars: 95 % interval by bootstrap.";
  };
  for (const char* quantity : quantities_with_limits)
    add(quantity, "q_1/q_0", true, &SweepLimit::ratio);
  add("kappa", "Nayak's parameter", true, &SweepLimit::nayak);
  return figures;
}

std::vector<Figure> sweep_heat_maps(const SweepRecord& record,
                                    const SweptResults& results) {
  std::vector<Figure> figures;
  if (record.keys.size() != 2 || record.combine != cases::Combine::product)
    return figures;
  for (const std::string& name : swept_quantities(results))
    for (const std::string& method : swept_methods(results))
      if (figures.size() < most_heat_maps && is_drawn_quantity(name) &&
          is_varied(results, method, name))
        figures.push_back(heat_map(record, results, name, method));
  return figures;
}

} // namespace asperity::reports
