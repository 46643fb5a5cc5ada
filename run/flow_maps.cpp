#include "run/flow_maps.hpp"

#include "results/result_reader.hpp"
#include "run/flow_of_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace asperity::run {
namespace {

/// The saved maps of realisation 0, the heaviest first.
std::vector<const results::Fields*> maps_of(const results::Result& result,
                                            const std::string& method) {
  std::vector<const results::Fields*> maps;
  for (const results::MethodRecord& record : result.methods)
    if (record.name == method && !record.realizations.empty())
      for (const results::Fields& map : record.realizations.front().fields)
        if (!map.gap_map().empty() && map.gap_map().size() == map.grid.size())
          maps.push_back(&map);
  std::ranges::sort(maps, std::ranges::greater{},
                    &results::Fields::nominal_pressure);
  return maps;
}

std::vector<double> values_of(const results::MapView& view) {
  std::vector<double> values;
  values.reserve(view.size());
  results::each_piece(view, [&](std::span<const double> piece) {
    values.insert(values.end(), piece.begin(), piece.end());
  });
  return values;
}

/// Keeps the rows of a flow map that are on the user's map. The narrowest place
/// is in its mirror images, too, and is marked on the map.
void keep_user_map(const results::Fields& fields, results::Table& table) {
  const Grid& cell = fields.grid;
  const Grid map = fields.map.grid(cell);
  if (map == cell || table.columns.front().values.empty())
    return;
  const auto folded = [](double place, double spacing, double length) {
    return std::min(place, length - spacing - place); // node i and n - 1 - i
  };
  const std::vector<double> x = table.values("x"), y = table.values("y"),
                            critical = table.values("is_critical");
  std::vector<std::size_t> kept;
  std::array<double, 2> narrowest{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < map.length_x - 0.5 * cell.spacing_x() &&
        y[i] < map.length_y - 0.5 * cell.spacing_y())
      kept.push_back(i);
    if (critical[i] > 0.0)
      narrowest = {folded(x[i], cell.spacing_x(), cell.length_x),
                   folded(y[i], cell.spacing_y(), cell.length_y)};
  }
  const auto distance = [&](std::size_t i) {
    return std::hypot(x[i] - narrowest[0], y[i] - narrowest[1]);
  };
  const std::size_t nearest = *std::ranges::min_element(kept, {}, distance);
  for (results::Column& column : table.columns) {
    std::vector<double> values;
    values.reserve(kept.size());
    for (const std::size_t i : kept)
      values.push_back(column.name != "is_critical" ? column.values[i]
                       : i == nearest               ? 1.0
                                                    : 0.0);
    column.values = std::move(values);
  }
}

void record_flow_map(const RunContext& run, const cases::MethodSpec& method,
                     const results::Result& result) {
  const mechanics::ContactCriterion criterion =
      method.contact_criterion(run.surfaces.of(method, 0).scales.rms_height);
  for (const results::Fields* map : maps_of(result, method.name)) {
    auto table = run.tally.attempt("flow map, " + method.name, [&] {
      const std::vector<double> pressure = values_of(map->pressure_map());
      const std::vector<double> gap = values_of(map->gap_map());
      return flow_map_table(method.name, map->grid, {criterion, pressure, gap},
                            method.border());
    });
    if (!table)
      return;
    if (table->columns.front().values.empty())
      continue;
    keep_user_map(*map, *table);
    run.writer->record_table(*table);
    return;
  }
}

} // namespace

void record_flow_maps(const RunContext& run,
                      std::span<const cases::MethodSpec> methods) {
  if (!run.contact_case.flow_study)
    return;
  run.root.act([&] {
    const results::Result result =
        results::read_result(run.writer->path(), results::MapsInFile::large);
    for (const cases::MethodSpec& method : methods)
      if (method.has_fields())
        record_flow_map(run, method, result);
  });
}

} // namespace asperity::run
