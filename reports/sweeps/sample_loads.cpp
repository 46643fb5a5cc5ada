#include "reports/sweeps/sample_loads.hpp"

#include "base/special_numbers.hpp"
#include "reports/figures/plot_parts.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/sweeps/sweep_scatter.hpp"
#include "results/types/curve_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

namespace asperity::reports {
namespace {

/// Contact area above which no outliers are named: the gaps vanish, and differ
/// by roundoff where contact is complete.
constexpr double complete_contact = 0.95;

using results::CurvePoint;

/// The rows of the table, and the method that has them.
const SweptCurve* curve_called(const SweptResult& result,
                               const std::string& method) {
  const auto found =
      std::ranges::find(result.curves, method, &SweptCurve::method);
  return found == result.curves.end() ? nullptr : &*found;
}

/// The first method that is no theory, or the first of all.
std::string method_of_samples(const SweptResults& results) {
  std::string first;
  for (const auto& result : results)
    for (const MethodSummary& method : result->summary.methods) {
      if (method.kind != "theory")
        return method.name;
      if (first.empty())
        first = method.name;
    }
  return first;
}

/// A pressure that is roundoff of the largest one of its curve is 0.
double state_of(const SweptCurve& curve, const CurvePoint& row, bool is_gap) {
  constexpr double roundoff = 1e-7;
  if (is_gap)
    return row.mean_gap / curve.rms_height;
  const double largest = std::ranges::max(curve.rows, {}, [](const auto& one) {
                           return std::abs(one.nominal_pressure);
                         }).nominal_pressure;
  return std::abs(row.nominal_pressure) > roundoff * std::abs(largest)
             ? row.nominal_pressure
             : 0.0;
}

/// The rows of each step, one for each curve; null: its step has not converged.
using RowsOfSteps = std::map<int, std::vector<const CurvePoint*>>;

/// @param is_gap  false: without rows of faces that a tension has parted, which
///                have a gap and no state at that tension
RowsOfSteps rows_of_steps(const std::vector<const SweptCurve*>& curves,
                          bool is_gap) {
  RowsOfSteps rows;
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const CurvePoint& row : curves[i]->rows)
      if (is_gap || row.nominal_pressure != 0.0 || row.area_fraction > 0.0)
        rows.try_emplace(row.step, curves.size()).first->second[i] = &row;
  return rows;
}

/// The first curve that has a row in a step.
std::size_t first_of(const std::vector<const CurvePoint*>& rows) {
  return static_cast<std::size_t>(std::ranges::find_if(rows, std::identity()) -
                                  rows.begin());
}

bool are_same_loads(const std::vector<const SweptCurve*>& curves,
                    const std::vector<const CurvePoint*>& rows, bool is_gap) {
  constexpr double tolerance = 1e-3; // of a load that a solver has reached
  const std::size_t first = first_of(rows);
  const double state = state_of(*curves[first], *rows[first], is_gap);
  for (std::size_t i = first; i < rows.size(); ++i)
    if (rows[i] != nullptr &&
        !(std::abs(state_of(*curves[i], *rows[i], is_gap) - state) <=
              tolerance * std::abs(state) &&
          rows[i]->is_unloading == rows[first]->is_unloading))
      return false;
  return true;
}

/// The steps at which the curves share their states, and what that is; without
/// a name if they share nothing.
std::pair<SampleColumn, RowsOfSteps>
shared_states(const std::vector<const SweptCurve*>& curves) {
  for (const bool is_gap : {false, true}) {
    RowsOfSteps steps = rows_of_steps(curves, is_gap);
    if (!steps.empty() && std::ranges::all_of(steps, [&](const auto& step) {
          return are_same_loads(curves, step.second, is_gap);
        }))
      return {is_gap ? SampleColumn{"mean_gap_over_rms_height", "1"}
                     : SampleColumn{"nominal_pressure", "Pa"},
              std::move(steps)};
  }
  return {};
}

void evaluate(SampleValues& column) {
  std::vector<double> known;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < column.values.size(); ++i)
    if (std::isfinite(column.values[i])) {
      known.push_back(column.values[i]);
      places.push_back(i);
    }
  column.spread = spread_of(known);
  for (const std::size_t i : outliers_of(known))
    column.outliers.push_back(places[i]);
}

/// The columns of studies that a row has: those that answer, then the others
/// in the order of all columns; others are in curves.csv of each sample.
std::vector<const results::CurveColumn*>
studied_columns(const std::vector<const SweptCurve*>& curves,
                const std::vector<AnswerColumn>& answers) {
  static constexpr std::array<std::string_view, 5> left_out{
      "", "fit", "adhesion", "certificate", "free edges"};
  std::vector<const results::CurveColumn*> found;
  for (const results::CurveColumn& column : results::curve_columns())
    if (std::ranges::count(left_out, column.owner()) == 0 &&
        !column.is_integer && column.use == results::ColumnUse::answer &&
        std::ranges::any_of(curves, [&](const SweptCurve* curve) {
          return std::ranges::any_of(curve->rows, [&](const CurvePoint& row) {
            return std::isfinite(row[column]);
          });
        }))
      found.push_back(&column);
  std::ranges::stable_sort(found, {}, [&](const results::CurveColumn* column) {
    return std::ranges::find(answers, column, &AnswerColumn::column);
  });
  return found;
}

/// Adds the numbers of a sample at a load.
/// @param row  null: it has none
void add_row(const SampleLoads& table,
             const std::vector<const results::CurveColumn*>& studied,
             const CurvePoint* row, SampleLoad& load) {
  if (row == nullptr) {
    for (SampleValues& column : load.columns)
      column.values.push_back(not_a_number);
    return;
  }
  load.columns[0].values.push_back(std::isfinite(row->area_fraction_corrected)
                                       ? row->area_fraction_corrected
                                       : row->area_fraction);
  load.columns[1].values.push_back(row->mean_gap);
  if (table.is_by_gap())
    load.columns[2].values.push_back(row->nominal_pressure);
  for (std::size_t i = 0; i < studied.size(); ++i)
    load.columns[table.n_common() + i].values.push_back((*row)[*studied[i]]);
}

std::string named_outliers(const SampleLoads& table,
                           const SampleValues& values) {
  std::string names;
  for (const std::size_t sample : values.outliers)
    names += (names.empty() ? "" : "; ") + table.samples[sample];
  return names;
}

constexpr const char* outlier_colors[] = {"#d55e00", "#009e73", "#cc79a7",
                                          "#e69f00", "#0072b2"};

/// The axis of a column or of the shared pressure, in the unit that suits its
/// largest value.
ChartAxis physical_axis(bool is_pressure, double largest) {
  ChartAxis axis = is_pressure
                       ? pressure_axis("", "nominal pressure p", 1.0, largest)
                       : length_axis("", "mean gap", 1.0, largest);
  axis.label = axis.other->label;
  return axis;
}

/// Adds the line of each sample, outliers by name.
void add_sample_lines(const SampleLoads& table, std::size_t judged, int x,
                      int y, ChartPanel& panel) {
  bool is_told = false;
  std::size_t n_outliers = 0;
  for (std::size_t i = 0; i < table.samples.size(); ++i) {
    const bool is_outlier =
        std::ranges::any_of(table.loads, [&](const SampleLoad& load) {
          return std::ranges::count(load.columns[judged].outliers, i) > 0;
        });
    const std::string label =
        is_outlier ? table.samples[i]
        : std::exchange(is_told, true)
            ? ""
            : fmt::format("one of {} maps", table.samples.size());
    panel.add(
        label,
        is_outlier
            ? line(outlier_colors[n_outliers++ % std::size(outlier_colors)],
                   1.0)
            : line("#56b4e9", 1.0),
        i, x, y);
  }
  panel.add("mean", line("#222222", 2.2), table.samples.size(), x, y);
}

/// Around the largest tension, beside which a load that presses is large.
void show_tension(const SampleLoads& table, double factor, ChartPanel& panel) {
  double least = 0.0;
  double largest = 0.0;
  for (const SampleLoad& load : table.loads)
    for (const double pressure : load.columns[2].values) {
      least = std::min(least, pressure * factor);
      largest = std::max(largest, pressure * factor);
    }
  panel.has_zero_line = true;
  if (least < 0.0 && largest > -3.0 * least) {
    panel.y.low = rounded(1.2 * least, 4);
    panel.y.high = rounded(-1.2 * least, 4);
  }
}

double largest_size(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values)
    largest = std::fmax(largest, std::abs(value));
  return largest;
}

Figure sample_figure(const SampleLoads& table, bool is_area) {
  const bool is_by_gap = table.is_by_gap();
  double stress = 0.0;
  double length = 0.0;
  for (const SampleLoad& load : table.loads) {
    stress = std::max(stress, is_by_gap ? largest_size(load.columns[2].values)
                                        : load.state);
    length = std::max(length, largest_size(load.columns[1].values));
  }
  const ChartAxis pressures = physical_axis(true, stress);
  const ChartAxis gaps = physical_axis(false, length);
  Figure figure;
  figure.name = !is_area    ? "samples-pressure-gap"
                : is_by_gap ? "samples-area-gap"
                            : "samples-area-pressure";
  figure.title = !is_area    ? "Pressure against mean gap"
                 : is_by_gap ? "Contact area against mean gap"
                             : "Contact area against pressure";
  CsvTable rows({"sample", "index", pressures.label, "area [%]", gaps.label});
  for (std::size_t i = 0; i <= table.samples.size(); ++i)
    for (const SampleLoad& load : table.loads) {
      if (!is_by_gap && !(load.state > 0.0))
        continue; // of which the axis has no logarithm
      const auto value = [&](std::size_t column) {
        const SampleValues& values = load.columns[column];
        return i < table.samples.size() ? values.values[i] : values.spread.mean;
      };
      rows.add(i < table.samples.size() ? table.samples[i] : "mean",
               {static_cast<double>(i),
                (is_by_gap ? value(2) : load.state) * pressures.other->factor,
                100.0 * value(0), value(1) * gaps.other->factor});
    }
  ChartPanel panel{
      .x = {.label = is_area && !is_by_gap ? pressures.label : gaps.label},
      .y = {.label = is_area ? "contact area [%]" : pressures.label},
      .has_narrow_legend = true};
  if (!is_by_gap)
    panel.y.is_log = panel.y.has_powers = true;
  panel.x.is_log = panel.x.has_powers = is_area && !is_by_gap;
  add_sample_lines(table, is_area ? 0 : table.n_common() - 1,
                   is_area && !is_by_gap ? 3 : 5, is_area ? 4 : 3, panel);
  if (is_by_gap && !is_area)
    show_tension(table, pressures.other->factor, panel);
  figure.caption = fmt::format(
      "Each map by {}, named where the pointer is, and the mean over all; maps "
      "that are outliers at a load have their own colour and name.",
      table.method);
  figure.is_physical = true;
  figure.panels = {std::move(panel)};
  figure.data = rows.text();
  return figure;
}

/// "6 maps", or "5 of 6 maps" where a map has no value.
std::string known_maps(const SampleValues& column) {
  const auto all = std::ssize(column.values);
  return column.known() < all
             ? fmt::format("{} of {} maps", column.known(), all)
             : fmt::format("{} maps", all);
}

bool are_all_zero(const SampleValues& column) {
  return column.known() > 0 && column.zeros() == column.known();
}

/// "; all are tight from 50 MPa on", or how many are at the heaviest load.
std::string heavier_zeros(const SampleLoads& table, std::size_t column) {
  const SampleLoad *first = nullptr, *last = nullptr;
  for (const SampleLoad& load : table.loads)
    if (!load.is_unloading && load.columns[column].known() > 0) {
      if (!are_all_zero(load.columns[column]))
        first = nullptr;
      else if (first == nullptr)
        first = &load;
      last = &load;
    }
  const std::string& zero = table.columns[column].zero;
  if (zero.empty() || table.is_by_gap() || last == nullptr)
    return "";
  if (first != nullptr)
    return fmt::format("; all are {} from {} on", zero,
                       table.state_text(*first));
  const SampleValues& heaviest = last->columns[column];
  return heaviest.zeros() == 0
             ? ""
             : fmt::format("; {} of {} are {} at {}", heaviest.zeros(),
                           known_maps(heaviest), zero, table.state_text(*last));
}

/// "Thermal resistance: 2.1e-06 m² K/W at 7 MPa, median of 6 maps (1.8e-06 m²
/// K/W to 2.3e-06 m² K/W)."
std::string answer(const SampleLoads& table, const SampleLoad& load,
                   std::size_t column) {
  const auto& [name, unit, words, zero] = table.columns[column];
  const SampleValues& values = load.columns[column];
  std::vector<double> known;
  for (const double value : values.values)
    if (std::isfinite(value))
      known.push_back(value);
  if (known.empty())
    return fmt::format("{}: no map has a value at {}.", words,
                       table.state_text(load));
  const auto [low, high] = std::ranges::minmax(known);
  return fmt::format("{}: {} at {}, median of {} ({} to {}){}{}.", words,
                     quantity_text(median(known), unit, 3),
                     table.state_text(load), known_maps(values),
                     quantity_text(low, unit, 2), quantity_text(high, unit, 2),
                     values.zeros() == 0 || zero.empty()
                         ? ""
                         : fmt::format(", {} of them {}", values.zeros(), zero),
                     heavier_zeros(table, column));
}

} // namespace

std::ptrdiff_t SampleValues::known() const {
  return std::ranges::count_if(values,
                               [](double x) { return std::isfinite(x); });
}

std::ptrdiff_t SampleValues::zeros() const {
  return std::ranges::count(values, 0.0);
}

std::string SampleLoads::state_text(const SampleLoad& load) const {
  return (is_by_gap() ? digits_text(load.state, 3) + " h_rms"
                      : quantity_text(load.state, "Pa", 3)) +
         (!load.is_unloading ? ""
          : is_by_gap()      ? ", way back"
                             : " (unloading)");
}

std::string SampleLoads::column_text(const SampleLoad& load,
                                     std::size_t column) const {
  const Spread& spread = load.columns[column].spread;
  return uncertain_text(spread.mean, spread.deviation, columns[column].unit);
}

std::string sample_name(const SweepRecord& record, std::size_t point) {
  return value_label(
      record.keys.front().values[record.points[point].choice.front()]);
}

SampleLoads sample_loads(const SweepRecord& record,
                         const SweptResults& results) {
  SampleLoads table;
  if (!has_samples(record))
    return table;
  table.method = method_of_samples(results);
  std::vector<const SweptCurve*> curves;
  for (const auto& result : results)
    if (const SweptCurve* curve = curve_called(*result, table.method);
        curve != nullptr && !curve->rows.empty()) {
      curves.push_back(curve);
      table.samples.push_back(sample_name(record, result->point));
    }
  RowsOfSteps steps;
  std::tie(table.state, steps) = shared_states(curves);
  if (table.state.name.empty())
    return table;
  const std::vector<AnswerColumn>& answers = results.front()->answers;
  const std::vector<const results::CurveColumn*> studied =
      studied_columns(curves, answers);
  table.columns = {{"area_fraction", "%"}, {"mean_gap", "m"}};
  if (table.is_by_gap())
    table.columns.push_back({"nominal_pressure", "Pa"});
  for (const results::CurveColumn* column : studied) {
    const bool is_share = column->range.highest == 1.0;
    SampleColumn& added = table.columns.emplace_back(SampleColumn{
        std::string(column->name), is_share ? "%" : std::string(column->unit)});
    if (const auto answer =
            std::ranges::find(answers, column, &AnswerColumn::column);
        answer != answers.end()) {
      added.words = answer->words;
      added.zero = answer->zero;
    }
  }
  for (const auto& [step, rows] : steps) {
    const std::size_t first = first_of(rows);
    SampleLoad load{state_of(*curves[first], *rows[first], table.is_by_gap()),
                    rows[first]->is_unloading,
                    {}};
    load.columns.resize(table.columns.size());
    for (const CurvePoint* row : rows)
      add_row(table, studied, row, load);
    for (SampleValues& column : load.columns)
      evaluate(column);
    if (load.columns[0].spread.mean > complete_contact)
      for (SampleValues& column : load.columns)
        column.outliers.clear();
    table.loads.push_back(std::move(load));
  }
  return table;
}

std::string sample_loads_csv(const SampleLoads& table) {
  std::string text = fmt::format("sample,method,{} [{}],is_unloading",
                                 table.state.name, table.state.unit);
  for (const SampleColumn& column : table.columns)
    text += fmt::format(",{} [{}]", column.name,
                        column.unit == "%" ? "1" : column.unit);
  text += "\n";
  const auto add = [&](const std::string& name, const SampleLoad& load,
                       const auto& cell) {
    text +=
        fmt::format("{},{},{:.10g},{}", csv_cell(name), csv_cell(table.method),
                    load.state, load.is_unloading ? 1 : 0);
    for (const SampleValues& column : load.columns)
      text += "," + cell(column);
    text += "\n";
  };
  for (const SampleLoad& load : table.loads)
    for (std::size_t i = 0; i < table.samples.size(); ++i)
      add(table.samples[i], load, [&](const SampleValues& column) {
        return csv_number(column.values[i]);
      });
  for (const SampleLoad& load : table.loads) {
    add("mean", load, [&](const SampleValues& column) {
      return csv_number(column.spread.mean);
    });
    add("standard deviation", load, [&](const SampleValues& column) {
      return csv_number(column.spread.deviation);
    });
    add("outliers", load, [&](const SampleValues& column) {
      return csv_cell(named_outliers(table, column));
    });
    add("samples with a value", load, [](const SampleValues& column) {
      return std::to_string(column.known());
    });
    add("samples with 0", load, [](const SampleValues& column) {
      return std::to_string(column.zeros());
    });
  }
  return text;
}

std::string sample_loads_text(const SampleLoads& table) {
  if (table.loads.empty())
    return "";
  const std::size_t second = table.n_common() - 1;
  std::size_t width = 8; // of "pressure"
  for (const SampleLoad& load : table.loads)
    width = std::max(width, table.state_text(load).size() + 2);
  std::string text = fmt::format(
      "{}, {} maps: mean and standard deviation of one map\n{:>{}}  {:>15}  "
      "{:>17}  outliers\n",
      table.method, table.samples.size(),
      table.is_by_gap() ? "mean gap" : "pressure", width, "contact area",
      table.is_by_gap() ? "pressure" : "mean gap");
  for (const SampleLoad& load : table.loads) {
    const std::string of_area = named_outliers(table, load.columns[0]);
    text += fmt::format(
        "{:>{}}  {:>15}  {:>17}  {}\n", table.state_text(load), width,
        table.column_text(load, 0), table.column_text(load, second),
        of_area.empty() ? named_outliers(table, load.columns[second])
                        : of_area);
  }
  return text;
}

const SampleLoad* usual_load(const SampleLoads& table) {
  const SampleLoad* nearest = nullptr;
  const auto distance = [](const SampleLoad& load) {
    return std::abs(std::log(load.columns[0].spread.mean / 0.1));
  };
  for (const SampleLoad& load : table.loads)
    if (nearest == nullptr || distance(load) < distance(*nearest))
      nearest = &load;
  return nearest;
}

std::string sample_sentence(const SampleLoads& table) {
  const SampleLoad* const load = usual_load(table);
  if (load == nullptr)
    return "";
  return fmt::format(
      "At {}{}, {} of the area touches{}, over {} maps (mean and standard "
      "deviation).",
      table.is_by_gap() ? "a mean gap of " : "", table.state_text(*load),
      table.column_text(*load, 0),
      table.is_by_gap()
          ? ""
          : ", and the mean gap is " + table.column_text(*load, 1),
      table.samples.size());
}

std::string sample_answers(const SampleLoads& table) {
  const SampleLoad* const load = usual_load(table);
  std::string sentences;
  for (std::size_t c = table.n_common(); c < table.columns.size(); ++c)
    if (!table.columns[c].words.empty())
      sentences += (sentences.empty() ? "" : " ") + answer(table, *load, c);
  return sentences;
}

std::vector<Figure> sample_figures(const SampleLoads& table) {
  if (table.loads.empty())
    return {};
  return {sample_figure(table, true), sample_figure(table, false)};
}

} // namespace asperity::reports
