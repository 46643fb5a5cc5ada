#include "run/stress_tables.hpp"

#include "results/result_reader.hpp"
#include "results/types/method_columns.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/continuum_block.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace asperity::run {
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

/// The first realisation of a method with saved maps; null if there is none.
results::Curve* curve_of(const cases::MethodSpec& method,
                         results::Result& result) {
  for (results::MethodRecord& record : result.methods)
    if (record.name == method.name && method.is_continuum() &&
        !record.realizations.empty())
      return &record.realizations.front();
  return nullptr;
}

/// The tables of one method.
class MethodStress {
public:
  MethodStress(const RunContext& run, const cases::MethodSpec& method,
               const methods::StressUnderMaps& stress)
      : run_(run), method_(method), stress_(stress) {}

  /// @param points   rows of the curve of the maps
  /// @param has_own  whether the result has a section of the method's own
  void record(std::span<const results::Fields> maps,
              std::span<const CurvePoint> points, bool has_own) const {
    const auto table = attempt("subsurface stress, ", [&] {
      return stress_table(method_.name, stress_, maps);
    });
    if (!table)
      return;
    record(methods::is_full_block(method_)
               ? own_stress_table(*table, maps, points)
               : *table);
    if (has_own)
      return;
    const Heaviest heaviest = heaviest_of(maps, *table);
    record(attempt("stress section, ", [&] {
      return methods::stress_section(method_.name, stress_, heaviest.map,
                                     heaviest.peak);
    }));
    if (maps.size() < 2 || !have_one_grid(maps))
      return;
    record(attempt("stress sections, ", [&] {
      return methods::stress_sections(method_.name, stress_, maps,
                                      heaviest.peak);
    }));
  }

private:
  template <class Make>
  std::optional<results::Table> attempt(const char* what,
                                        const Make& make) const {
    return run_.tally.attempt(what + method_.name, make);
  }

  void record(const std::optional<results::Table>& table) const {
    if (table)
      run_.writer->record_table(*table);
  }

  const RunContext& run_;
  const cases::MethodSpec& method_;
  const methods::StressUnderMaps& stress_;
};

} // namespace

results::Table stress_table(const std::string& method,
                            const methods::StressUnderMaps& stress,
                            std::span<const results::Fields> maps) {
  results::Table table{"stress-inside-" + method,
                       "The maximum stress below the contact surface, " +
                           method,
                       {{"nominal_pressure", "Pa"},
                        {"von_mises", "Pa"},
                        {"largest_shear", "Pa"},
                        {"depth", "m"},
                        {"x", "m"},
                        {"y", "m"}}};
  for (const results::Fields& map : maps) {
    const auto [peak, largest_shear] = stress.strongest(map);
    const std::size_t columns = static_cast<std::size_t>(map.grid.points_x);
    const std::size_t node = map.map.node_on_map(peak.node, map.grid);
    const std::size_t line = node / columns;
    table.add({map.nominal_pressure, peak.von_mises, largest_shear, peak.depth,
               static_cast<double>(node % columns) * map.grid.spacing_x(),
               static_cast<double>(line) * map.grid.spacing_y()});
  }
  return table;
}

results::Table own_stress_table(const results::Table& of_pressure,
                                std::span<const results::Fields> maps,
                                std::span<const CurvePoint> rows) {
  results::Table table = of_pressure;
  const auto own = [&](const char* name, const char* unit,
                       const results::CurveColumn* number) {
    results::Column column{name, unit, {}};
    for (const results::Fields& map : maps)
      column.values.push_back(row_of(map, rows)[*number]);
    return column;
  };
  table.columns = {
      of_pressure.columns.front(),
      own("von_mises", "Pa", &columns::von_mises),
      own("depth", "m", &columns::von_mises_depth),
      {"von_mises_from_pressure", "Pa", of_pressure.values("von_mises")},
      {"depth_from_pressure", "m", of_pressure.values("depth")}};
  return table;
}

void record_stress_inside(const RunContext& run,
                          std::span<const cases::MethodSpec> methods,
                          const mechanics::Scales& scales) {
  if (!run.contact_case.report.stress_inside)
    return;
  results::Result result =
      results::read_result(run.writer->path(), results::MapsInFile::large);
  for (const cases::MethodSpec& method : methods) {
    results::Curve* const curve = curve_of(method, result);
    if (curve == nullptr)
      continue;
    std::erase_if(curve->fields,
                  [](const auto& map) { return !has_maps(map); });
    if (curve->fields.empty())
      continue;
    const methods::StressUnderMaps stress(
        methods::continuum_of(method, run.contact_case.material, scales),
        run.pool.threads());
    MethodStress(run, method, stress)
        .record(curve->fields, curve->points,
                methods::is_full_block(method) &&
                    result.table("stress-section-" + method.name) != nullptr);
  }
}

} // namespace asperity::run
