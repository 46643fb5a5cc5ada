#include "reports/sweeps/sample_loads.hpp"

#include "reports/figures/plot_parts.hpp"
#include "reports/numbers/number_text.hpp"
#include "reports/sweeps/sweep_scatter.hpp"
#include "results/types/curve_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

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

bool are_same_loads(const std::vector<CurvePoint>& one,
                    const std::vector<CurvePoint>& other) {
  constexpr double tolerance = 1e-3; // of a load that a solver has reached
  return std::ranges::equal(
      one, other, [](const CurvePoint& a, const CurvePoint& b) {
        return std::abs(a.nominal_pressure - b.nominal_pressure) <=
                   tolerance * std::abs(a.nominal_pressure) &&
               a.is_unloading == b.is_unloading;
      });
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

/// The columns of studies that a row has, in the order of all columns.
std::vector<const results::CurveColumn*>
studied_columns(const std::vector<const SweptCurve*>& curves) {
  std::vector<const results::CurveColumn*> found;
  for (const results::CurveColumn& column : results::curve_columns())
    if (!column.owner().empty() && column.owner() != "fit" &&
        !column.is_integer && column.use == results::ColumnUse::answer &&
        std::ranges::any_of(curves, [&](const SweptCurve* curve) {
          return std::ranges::any_of(curve->rows, [&](const CurvePoint& row) {
            return std::isfinite(row[column]);
          });
        }))
      found.push_back(&column);
  return found;
}

std::string named_outliers(const SampleLoads& table,
                           const SampleValues& values) {
  std::string names;
  for (const std::size_t sample : values.outliers)
    names += (names.empty() ? "" : "; ") + table.samples[sample];
  return names;
}

std::string percent(double share, int digits = 3) {
  return std::isfinite(share) ? fmt::format("{:.{}g} %", 100.0 * share, digits)
                              : "–";
}

/// "33.1 nm (standard deviation 2.3 nm)"
std::string with_deviation(const SampleValues& values, bool is_share) {
  const auto text = [&](double value, int digits) {
    return is_share ? percent(value, digits)
                    : quantity_text(value, "m", digits);
  };
  return fmt::format("{} (standard deviation {})", text(values.spread.mean, 3),
                     text(values.spread.deviation, 2));
}

constexpr const char* outlier_colors[] = {"#d55e00", "#009e73", "#cc79a7",
                                          "#e69f00", "#0072b2"};

Figure sample_figure(const SampleLoads& table, bool is_area) {
  const double mega = 1e-6;
  const double nano = 1e9;
  Figure figure;
  figure.name = is_area ? "samples-area-pressure" : "samples-pressure-gap";
  figure.title =
      is_area ? "Contact area against pressure" : "Pressure against mean gap";
  CsvTable rows({"sample", "index", "p [MPa]", "area [%]", "mean gap [nm]"});
  ChartPanel panel{.x = {.label = is_area ? "p [MPa]" : "mean gap [nm]"},
                   .y = {.label = is_area ? "contact area [%]" : "p [MPa]",
                         .is_log = true,
                         .has_powers = true},
                   .has_narrow_legend = true};
  panel.x.is_log = panel.x.has_powers = is_area;
  const int x = is_area ? 3 : 5;
  const int y = is_area ? 4 : 3;
  const auto add = [&](const std::string& name, std::size_t index,
                       const auto& value) {
    for (const SampleLoad& load : table.loads)
      rows.add(name,
               {static_cast<double>(index), load.pressure * mega,
                100.0 * value(load.columns[0]), nano * value(load.columns[1])});
  };
  bool is_told = false;
  std::size_t n_outliers = 0;
  for (std::size_t i = 0; i < table.samples.size(); ++i) {
    add(table.samples[i], i,
        [&](const SampleValues& column) { return column.values[i]; });
    const bool is_outlier =
        std::ranges::any_of(table.loads, [&](const SampleLoad& load) {
          return std::ranges::count(load.columns[is_area ? 0 : 1].outliers, i) >
                 0;
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
  add("mean", table.samples.size(),
      [](const SampleValues& column) { return column.spread.mean; });
  panel.add("mean", line("#222222", 2.2), table.samples.size(), x, y);
  figure.caption = fmt::format(
      "{} of each map, named where the pointer is, and the mean over all; maps "
      "that are outliers at a load have their own colour and name.",
      table.method);
  figure.is_physical = true;
  figure.panels = {std::move(panel)};
  figure.data = rows.text();
  return figure;
}

} // namespace

std::ptrdiff_t SampleValues::known() const {
  return std::ranges::count_if(values,
                               [](double x) { return std::isfinite(x); });
}

std::ptrdiff_t SampleValues::zeros() const {
  return std::ranges::count(values, 0.0);
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
      if (!curves.empty() && !are_same_loads(curves[0]->rows, curve->rows))
        return table;
      curves.push_back(curve);
      table.samples.push_back(value_label(
          record.keys[0].values[record.points[result->point].choice[0]]));
    }
  if (curves.empty())
    return table;
  const std::vector<const results::CurveColumn*> studied =
      studied_columns(curves);
  table.columns = {{"area_fraction", "1"}, {"mean_gap", "m"}};
  for (const results::CurveColumn* column : studied)
    table.columns.push_back(
        {std::string(column->name), std::string(column->unit)});
  for (std::size_t step = 0; step < curves[0]->rows.size(); ++step) {
    const CurvePoint& of_first = curves[0]->rows[step];
    SampleLoad load{of_first.nominal_pressure, of_first.is_unloading, {}};
    load.columns.resize(table.columns.size());
    for (const SweptCurve* curve : curves) {
      const CurvePoint& row = curve->rows[step];
      load.columns[0].values.push_back(
          std::isfinite(row.area_fraction_corrected)
              ? row.area_fraction_corrected
              : row.area_fraction);
      load.columns[1].values.push_back(row.mean_gap);
      for (std::size_t i = 0; i < studied.size(); ++i)
        load.columns[2 + i].values.push_back(row[*studied[i]]);
    }
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
  std::string text = "sample,method,nominal_pressure [Pa],is_unloading";
  for (const SampleColumn& column : table.columns)
    text += fmt::format(",{} [{}]", column.name, column.unit);
  text += "\n";
  const auto add = [&](const std::string& name, const SampleLoad& load,
                       const auto& cell) {
    text +=
        fmt::format("{},{},{:.10g},{}", csv_cell(name), csv_cell(table.method),
                    load.pressure, load.is_unloading ? 1 : 0);
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
  std::string text = fmt::format(
      "{}, {} maps: mean and standard deviation of one map\n{:>10}  {:>16}  "
      "{:>22}  outliers\n",
      table.method, table.samples.size(), "pressure", "contact area",
      "mean gap");
  for (const SampleLoad& load : table.loads) {
    const SampleValues& area = load.columns[0];
    const SampleValues& gap = load.columns[1];
    const std::string of_area = named_outliers(table, area);
    text += fmt::format("{:>10}  {:>7} ± {:>7}  {:>10} ± {:>10}  {}\n",
                        quantity_text(load.pressure, "Pa", 3),
                        percent(area.spread.mean),
                        percent(area.spread.deviation, 2),
                        quantity_text(gap.spread.mean, "m", 3),
                        quantity_text(gap.spread.deviation, "m", 2),
                        of_area.empty() ? named_outliers(table, gap) : of_area);
  }
  return text;
}

std::string sample_sentence(const SampleLoads& table) {
  const SampleLoad* nearest = nullptr;
  const auto distance = [](const SampleLoad& load) {
    return std::abs(std::log(load.columns[0].spread.mean / 0.1));
  };
  for (const SampleLoad& load : table.loads)
    if (nearest == nullptr || distance(load) < distance(*nearest))
      nearest = &load;
  if (nearest == nullptr)
    return "";
  return fmt::format(
      "At {}, {} of the area touches, and the mean gap is {}, over {} maps.",
      quantity_text(nearest->pressure, "Pa", 3),
      with_deviation(nearest->columns[0], true),
      with_deviation(nearest->columns[1], false), table.samples.size());
}

std::vector<Figure> sample_figures(const SampleLoads& table) {
  if (table.loads.empty())
    return {};
  return {sample_figure(table, true), sample_figure(table, false)};
}

} // namespace asperity::reports
