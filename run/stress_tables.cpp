#include "run/stress_tables.hpp"

#include "methods/chosen.hpp"
#include "methods/continuum_block.hpp"
#include "methods/sharing.hpp"
#include "results/result_reader.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// What all ranks need to know of a map.
struct MapHead {
  int step;
  double nominal_pressure; ///< [Pa]
  Grid grid;
  results::MapInCell map;
};

/// The maps of a method for all ranks, whose pressures rank 0 alone can read.
std::vector<results::Fields> maps_for_ranks(RootWork& root,
                                            std::vector<results::Fields> maps) {
  const std::vector<MapHead> heads = root.value([&] {
    std::vector<MapHead> own;
    own.reserve(maps.size());
    for (const results::Fields& map : maps)
      own.push_back({map.step, map.nominal_pressure, map.grid, map.map});
    return own;
  });
  maps.resize(heads.size());
  for (std::size_t k = 0; k < heads.size(); ++k) {
    maps[k].step = heads[k].step;
    maps[k].nominal_pressure = heads[k].nominal_pressure;
    maps[k].grid = heads[k].grid;
    maps[k].map = heads[k].map;
  }
  return maps;
}

/// The tables of one method.
class MethodStress {
public:
  MethodStress(const RunContext& run, const cases::MethodSpec& method,
               const methods::StressUnderMaps& stress, RootWork& root)
      : run_(run), method_(method), stress_(stress), root_(root) {}

  /// @param points   rows of the curve of the maps, on rank 0
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
    return run_.tally.attempt(what + method_.name, [&] {
      results::Table table;
      root_.together([&] { table = make(); });
      return table;
    });
  }

  void record(const std::optional<results::Table>& table) const {
    if (table)
      root_.act([&] { run_.writer->record_table(*table); });
  }

  const RunContext& run_;
  const cases::MethodSpec& method_;
  const methods::StressUnderMaps& stress_;
  RootWork& root_;
};

} // namespace

results::Table stress_table(const std::string& method,
                            const methods::StressUnderMaps& stress,
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
    const std::size_t node = map.map.node_on_map(peak.node, map.grid);
    const std::size_t column = node % columns;
    const std::size_t row = node / columns;
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

void record_stress_inside(const RunContext& run,
                          std::span<const cases::MethodSpec> methods,
                          const mechanics::Scales& scales) {
  if (!run.contact_case.report.stress_inside)
    return;
  results::Result result;
  run.root.act([&] {
    result =
        results::read_result(run.writer->path(), results::MapsInFile::large);
  });
  for (const cases::MethodSpec& method : methods) {
    results::Curve none;
    results::Curve* const found = curve_of(method, result);
    results::Curve& curve = found != nullptr ? *found : none;
    std::erase_if(curve.fields, [](const auto& map) { return !has_maps(map); });
    const std::vector<results::Fields> maps =
        maps_for_ranks(run.root, std::move(curve.fields));
    if (maps.empty())
      continue;
    const mechanics::ElasticBlock block =
        methods::continuum_of(method, run.contact_case.material, scales);
    const bool is_shared = run.root.ranks() != nullptr &&
                           std::ranges::all_of(maps, [&](const auto& map) {
                             return methods::is_shared_by_ranks(
                                 method, map.grid, run.root.ranks()->size());
                           });
    if (is_shared) {
      const methods::StressUnderMaps stress(block, run.threads_a_rank,
                                            run.root.ranks());
      MethodStress(run, method, stress, run.root)
          .record(maps, curve.points, false);
      continue;
    }
    run.root.act([&] {
      RootWork alone;
      MethodStress(run, method,
                   methods::StressUnderMaps(block, run.pool.threads()), alone)
          .record(maps, curve.points,
                  methods::is_full_block(method) &&
                      result.table("stress-section-" + method.name) != nullptr);
    });
  }
}

} // namespace asperity::run
