#include "app/run/stress_tables.hpp"

#include "app/methods/chosen.hpp"
#include "app/methods/continuum_block.hpp"
#include "app/methods/shared_load_steps.hpp"
#include "app/run/shared_stress.hpp"
#include "results/result_reader.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace asperity::app {
namespace {

using contact::StressPeak;
using results::CurvePoint;

bool has_maps(const results::Fields& fields) {
  return fields.nominal_pressure > 0.0 && !fields.pressure_map().empty() &&
         fields.pressure_map().size() == fields.grid.size();
}

const CurvePoint& row_of(const results::Fields& map,
                         std::span<const CurvePoint> rows) {
  return *std::find_if(rows.begin(), rows.end(), [&](const CurvePoint& row) {
    return row.step == map.step;
  });
}

/// The map with the highest load and its strongest point.
struct Heaviest {
  const results::Fields& map;
  StressPeak peak;
};

/// @param table  stress_table() of these maps
Heaviest heaviest_of(std::span<const results::Fields> maps,
                     const results::Table& table) {
  const auto heaviest = std::max_element(
      maps.begin(), maps.end(), [](const auto& a, const auto& b) {
        return a.nominal_pressure < b.nominal_pressure;
      });
  const auto row = static_cast<std::size_t>(heaviest - maps.begin());
  const Grid& grid = heaviest->grid;
  return {*heaviest,
          {table.values("von_mises")[row], table.values("depth")[row],
           grid.index(static_cast<int>(std::lround(table.values("x")[row] /
                                                   grid.spacing_x())),
                      static_cast<int>(std::lround(table.values("y")[row] /
                                                   grid.spacing_y())))}};
}

/// Returns true if the maps have one grid, so that one plane cuts all of them.
bool have_one_grid(std::span<const results::Fields> maps) {
  return std::ranges::all_of(
      maps, [&](const auto& map) { return map.grid == maps.front().grid; });
}

/// All ranks if they have shared the rows of these maps, or this process.
std::unique_ptr<StressUnderMaps>
stress_of(const cases::MethodSpec& method, const mechanics::ElasticBlock& block,
          std::span<const results::Fields> maps, const StressWorkers& workers) {
  const bool is_shared = std::ranges::all_of(maps, [&](const auto& map) {
    return is_shared_by_ranks(method, map.grid, workers.n_ranks);
  });
  if (is_shared)
    return std::make_unique<SharedStress>(block, workers.threads_a_rank);
  return std::make_unique<StressUnderMaps>(block, workers.threads);
}

} // namespace

results::Table stress_table(const std::string& method,
                            const StressUnderMaps& stress,
                            std::span<const results::Fields> maps) {
  results::Column pressure{"nominal_pressure", "Pa", {}};
  results::Column strongest{"von_mises", "Pa", {}};
  results::Column shear{"largest_shear", "Pa", {}};
  results::Column depth{"depth", "m", {}};
  results::Column x{"x", "m", {}};
  results::Column y{"y", "m", {}};
  for (const results::Fields& map : maps) {
    const auto [peak, largest_shear] = stress.strongest(map);
    const std::size_t columns = static_cast<std::size_t>(map.grid.points_x);
    pressure.values.push_back(map.nominal_pressure);
    strongest.values.push_back(peak.von_mises);
    shear.values.push_back(largest_shear);
    depth.values.push_back(peak.depth);
    const std::size_t column = peak.node % columns;
    const std::size_t row = peak.node / columns;
    x.values.push_back(static_cast<double>(column) * map.grid.spacing_x());
    y.values.push_back(static_cast<double>(row) * map.grid.spacing_y());
  }
  return {"stress-inside-" + method,
          "The maximum stress below the contact surface, " + method,
          {pressure, strongest, shear, depth, x, y}};
}

results::Table own_stress_table(const results::Table& of_pressure,
                                std::span<const results::Fields> maps,
                                std::span<const CurvePoint> rows) {
  results::Table table = of_pressure;
  const auto own = [&](const char* name, const char* unit,
                       double CurvePoint::*number) {
    results::Column column{name, unit, {}};
    for (const results::Fields& map : maps)
      column.values.push_back(row_of(map, rows).*number);
    return column;
  };
  table.columns = {
      of_pressure.columns.front(),
      own("von_mises", "Pa", &CurvePoint::von_mises),
      own("depth", "m", &CurvePoint::von_mises_depth),
      {"von_mises_from_pressure", "Pa", of_pressure.values("von_mises")},
      {"depth_from_pressure", "m", of_pressure.values("depth")}};
  return table;
}

void record_stress_inside(const cases::Case& contact_case,
                          std::span<const cases::MethodSpec> methods,
                          const mechanics::Scales& scales,
                          const StressWorkers& workers,
                          results::ResultWriter& writer, Tally& tally) {
  if (!contact_case.report.stress_inside)
    return;
  results::Result result =
      results::read_result(writer.path(), results::MapsInFile::large);
  for (results::MethodRecord& record : result.methods) {
    const auto method =
        std::find_if(methods.begin(), methods.end(),
                     [&](const auto& one) { return one.name == record.name; });
    if (method == methods.end() || !method->is_continuum() ||
        record.realizations.empty())
      continue;
    results::Curve& curve = record.realizations.front();
    std::vector<results::Fields> maps = std::move(curve.fields);
    std::erase_if(maps, [](const auto& map) { return !has_maps(map); });
    if (maps.empty())
      continue;
    const mechanics::ElasticBlock block =
        continuum_of(*method, contact_case.material, scales);
    const std::unique_ptr<StressUnderMaps> stress =
        stress_of(*method, block, maps, workers);
    const auto table = tally.attempt("subsurface stress, " + method->name, [&] {
      return stress_table(method->name, *stress, maps);
    });
    if (!table)
      continue;
    writer.record_table(is_full_block(*method)
                            ? own_stress_table(*table, maps, curve.points)
                            : *table);
    const bool has_own =
        is_full_block(*method) &&
        result.table("stress-section-" + method->name) != nullptr;
    if (has_own)
      continue;
    const Heaviest heaviest = heaviest_of(maps, *table);
    const auto section = tally.attempt("stress section, " + method->name, [&] {
      return stress_section(method->name, *stress, heaviest.map, heaviest.peak);
    });
    if (section)
      writer.record_table(*section);
    if (maps.size() < 2 || !have_one_grid(maps))
      continue;
    const auto sections =
        tally.attempt("stress sections, " + method->name, [&] {
          return stress_sections(method->name, *stress, maps, heaviest.peak);
        });
    if (sections)
      writer.record_table(*sections);
  }
}

} // namespace asperity::app
