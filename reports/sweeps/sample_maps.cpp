#include "reports/sweeps/sample_maps.hpp"

#include "reports/analysis/exact.hpp"
#include "reports/numbers/number_text.hpp"
#include "results/types/method_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace asperity::reports {
namespace {

/// Share that is shown as zero: a path of finite steps knows no smaller loss.
constexpr double least_share = 1e-4;

/// A column of the table, from a number per sample.
struct MapColumn {
  std::string head;
  std::string unit; ///< SI; "%": a share
  std::vector<double> values;
  std::vector<bool> is_bound = {}; ///< of each value, which is a lower bound
};

/// One sample with what the table needs of it.
struct SampleCurve {
  const SweptResult* result;
  const SweptCurve* curve;
};

std::vector<SampleCurve> samples_of(const SweptResults& results,
                                    const std::string& method) {
  std::vector<SampleCurve> samples;
  for (const auto& result : results)
    for (const SweptCurve& curve : result->curves)
      if (curve.method == method && !curve.rows.empty())
        samples.push_back({result.get(), &curve});
  return samples;
}

double quantity_of(const SampleCurve& sample, const std::string& name) {
  const Estimate* const found =
      swept_estimate(*sample.result, sample.curve->method, name);
  return found == nullptr ? not_a_number : found->value;
}

/// The state of the largest tension of a path.
struct TensionState {
  double tension = not_a_number; ///< [Pa]; NaN: no load pulls
  double gap = not_a_number;     ///< [m]
  double area = not_a_number;    ///< not known where the faces jump next
  bool is_bound = false;
};

TensionState tension_of(const SampleCurve& sample) {
  TensionState found;
  if (!std::isfinite(quantity_of(sample, "pull_off_pressure")))
    return found;
  const std::vector<results::CurvePoint>& rows = sample.curve->rows;
  found.tension = largest_tension(rows);
  found.is_bound = !why_more_may_hold(rows).empty();
  for (const results::CurvePoint& row : rows)
    if (-row.nominal_pressure == found.tension) {
      found.gap = row.mean_gap;
      found.area = row.area_fraction;
    } else if (-row[columns::jump_pressure] == found.tension) {
      found.gap = row[columns::jump_gap];
    }
  return found;
}

std::vector<MapColumn>
tension_columns(const std::vector<SampleCurve>& samples) {
  MapColumn tensions{"largest tension", "Pa", {}};
  MapColumn gaps{"mean gap there", "m", {}};
  MapColumn areas{"contact there", "%", {}};
  MapColumn losses{"work lost, of the work of adhesion", "%", {}};
  for (const SampleCurve& sample : samples) {
    const TensionState state = tension_of(sample);
    tensions.values.push_back(state.tension);
    tensions.is_bound.push_back(state.is_bound);
    gaps.values.push_back(state.gap);
    areas.values.push_back(state.area);
    losses.values.push_back(quantity_of(sample, "dissipated_energy"));
  }
  if (std::ranges::none_of(tensions.values,
                           [](double one) { return std::isfinite(one); }))
    return {};
  return {tensions, gaps, areas, losses};
}

/// Area and gap at the usual load.
std::vector<MapColumn> load_columns(const SampleLoads& loads) {
  const SampleLoad* const load = usual_load(loads);
  if (load == nullptr)
    return {};
  const std::string at = " at " + loads.state_text(*load);
  return {{"contact area" + at, "%", load->columns[0].values},
          {"mean gap" + at, "m", load->columns[1].values}};
}

std::string map_cell(const MapColumn& column, double value, int digits) {
  return std::abs(value) < least_share && column.unit == "%"
             ? "0 %"
             : quantity_text(value, column.unit, digits);
}

Spread known_spread(const MapColumn& column) {
  std::vector<double> known;
  for (const double value : column.values)
    if (std::isfinite(value))
      known.push_back(value);
  return spread_of(known);
}

/// "The largest tension is 3.1 ± 1.2 MPa over 2 maps (mean and standard
/// deviation)."
std::string tension_sentence(const MapColumn& tensions) {
  const auto count = std::ranges::count_if(
      tensions.values, [](double one) { return std::isfinite(one); });
  if (count < 2)
    return "";
  const bool is_bound = std::ranges::count(tensions.is_bound, true) > 0;
  const Spread spread = known_spread(tensions);
  return fmt::format(
      "The largest tension is {}{} over {} maps (mean and standard "
      "deviation){}.",
      is_bound ? "at least " : "",
      uncertain_text(spread.mean, spread.deviation, "Pa"), count,
      is_bound ? ", because some paths end in tension or never press the faces"
               : "");
}

} // namespace

SampleMaps sample_maps(const SweepRecord& record, const SweptResults& results,
                       const SampleLoads& loads) {
  SampleMaps maps;
  if (!has_samples(record))
    return maps;
  const std::vector<SampleCurve> samples = samples_of(results, loads.method);
  if (samples.empty())
    return maps;
  MapColumn heights{"rms height", "m", {}};
  for (const SampleCurve& sample : samples)
    heights.values.push_back(sample.curve->rms_height);
  std::vector<MapColumn> columns = tension_columns(samples);
  if (columns.empty())
    columns = load_columns(loads);
  else
    maps.sentence = tension_sentence(columns.front());
  columns.insert(columns.begin(), std::move(heights));
  for (const MapColumn& column : columns)
    maps.heads.push_back(column.head);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    SampleMap& row = maps.rows.emplace_back();
    row.point = samples[i].result->point;
    row.name = sample_name(record, row.point);
    for (const MapColumn& column : columns)
      row.cells.push_back(
          (!column.is_bound.empty() && column.is_bound[i] ? "≥ " : "") +
          map_cell(column, column.values[i], 3));
  }
  SampleMap mean{.name = "mean", .is_statistic = true};
  SampleMap deviation{.name = "standard deviation", .is_statistic = true};
  for (const MapColumn& column : columns) {
    const Spread spread = known_spread(column);
    mean.cells.push_back(map_cell(column, spread.mean, 3));
    deviation.cells.push_back(map_cell(column, spread.deviation, 2));
  }
  maps.rows.push_back(std::move(mean));
  maps.rows.push_back(std::move(deviation));
  return maps;
}

std::string sample_maps_text(const SampleMaps& maps) {
  if (maps.sentence.empty())
    return "";
  std::size_t width = 18; // of "standard deviation"
  for (const SampleMap& row : maps.rows)
    width = std::max(width, row.name.size());
  std::string text = fmt::format("{:<{}}", "map", width);
  for (const std::string& head : maps.heads)
    text += fmt::format("  {:>15}", head.substr(0, head.find(',')));
  for (const SampleMap& row : maps.rows) {
    text += fmt::format("\n{:<{}}", row.name, width);
    for (const std::string& cell : row.cells)
      text += fmt::format("  {:>15}", cell);
  }
  return text + "\n" + maps.sentence + "\n";
}

} // namespace asperity::reports
