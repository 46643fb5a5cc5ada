#include "run/flow_maps.hpp"

#include "results/result_reader.hpp"
#include "run/flow_of_step.hpp"

#include <algorithm>

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

void record_flow_map(const RunContext& run, const cases::MethodSpec& method,
                     const results::Result& result) {
  const mechanics::ContactCriterion criterion =
      method.contact_criterion(run.surfaces.of(method, 0).scales.rms_height);
  for (const results::Fields* map : maps_of(result, method.name)) {
    const auto table = run.tally.attempt("flow map, " + method.name, [&] {
      const std::vector<double> pressure = values_of(map->pressure_map());
      const std::vector<double> gap = values_of(map->gap_map());
      return flow_map_table(method.name, map->grid, {criterion, pressure, gap},
                            method.border());
    });
    if (!table)
      return;
    if (table->columns.front().values.empty())
      continue;
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
