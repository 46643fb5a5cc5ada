#include "app/stress_tables.hpp"

#include "app/continuum_block.hpp"
#include "results/result_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::app {
namespace {

using contact::StressInside;
using contact::StressPeak;
using contact::StressPlane;

constexpr int section_rows = 49;      ///< planes of a section, the face's too
constexpr int section_columns = 257;  ///< at most
constexpr double section_depth = 4.0; ///< in depths of the strongest point
constexpr double section_reach = 1.5; ///< to either side, in its own depth
constexpr double below_layers = 1.5;  ///< it shows this, in their thickness

/// Of a block that goes on for ever [m].
double depth_of_section(const contact::ElasticBlock& block, double peak_depth) {
  double layers = 0.0;
  for (const contact::BondedLayer& layer : block.layers)
    layers += layer.thickness;
  return std::max(section_depth * peak_depth, below_layers * layers);
}

/// The nodes of a section along x, as offsets from the strongest point.
std::vector<int> offsets_of(const Grid& grid, double depth) {
  const int reach = std::min(
      static_cast<int>(std::ceil(section_reach * depth / grid.spacing_x())),
      grid.points_x / 2);
  const int stride =
      std::max(1, (2 * reach + section_columns - 1) / section_columns);
  std::vector<int> offsets;
  for (int offset = -(reach / stride) * stride; offset <= reach;
       offset += stride)
    offsets.push_back(offset);
  return offsets;
}

bool has_maps(const results::Fields& fields) {
  return fields.nominal_pressure > 0.0 && !fields.pressure.empty() &&
         fields.pressure.size() == fields.grid.size();
}

} // namespace

results::Table stress_table(const std::string& method,
                            const contact::ElasticBlock& block,
                            std::span<const results::Fields> maps,
                            int threads) {
  results::Column pressure{"nominal_pressure", "Pa", {}};
  results::Column strongest{"von_mises", "Pa", {}};
  results::Column shear{"largest_shear", "Pa", {}};
  results::Column depth{"depth", "m", {}};
  results::Column x{"x", "m", {}};
  results::Column y{"y", "m", {}};
  for (const results::Fields& map : maps) {
    const StressInside inside(map.grid, block, map.pressure, threads);
    const StressPeak peak = inside.strongest();
    const std::size_t columns = static_cast<std::size_t>(map.grid.points_x);
    pressure.values.push_back(map.nominal_pressure);
    strongest.values.push_back(peak.von_mises);
    shear.values.push_back(contact::largest_shear(
        inside.at_depth(peak.depth, peak.side))[peak.node]);
    depth.values.push_back(peak.depth);
    x.values.push_back(static_cast<double>(peak.node % columns) *
                       map.grid.spacing_x());
    y.values.push_back(static_cast<double>(peak.node / columns) *
                       map.grid.spacing_y());
  }
  return {"stress-inside-" + method,
          "The strongest stress below the face, " + method,
          {pressure, strongest, shear, depth, x, y}};
}

results::Table stress_section(const std::string& method,
                              const contact::ElasticBlock& block,
                              const results::Fields& map,
                              const StressPeak& peak, int threads) {
  const Grid& grid = map.grid;
  const StressInside inside(grid, block, map.pressure, threads);
  const int peak_x = static_cast<int>(peak.node) % grid.points_x;
  const int peak_y = static_cast<int>(peak.node) / grid.points_x;
  const double whole_depth = depth_of_section(block, peak.depth);
  const double deepest = std::min(whole_depth, block.thickness);
  const std::vector<int> offsets = offsets_of(grid, whole_depth);
  results::Column depth{"depth", "m", {}};
  results::Column x{"x", "m", {}};
  results::Column strength{"von_mises", "Pa", {}};
  for (int row = 0; row < section_rows; ++row) {
    const double z = deepest * row / (section_rows - 1);
    const std::vector<double> plane = contact::von_mises(inside.at_depth(z));
    for (const int offset : offsets) {
      const int ix = (peak_x + offset + grid.points_x) % grid.points_x;
      depth.values.push_back(z);
      x.values.push_back(offset * grid.spacing_x());
      strength.values.push_back(plane[grid.index(ix, peak_y)]);
    }
  }
  return {"stress-section-" + method,
          fmt::format("Von Mises stress below the face at p = {:.6g} Pa, {}",
                      map.nominal_pressure, method),
          {depth, x, strength}};
}

void record_stress_inside(const cases::Case& rough_case,
                          std::span<const cases::MethodSpec> methods,
                          const cases::Scales& scales, int threads,
                          results::ResultWriter& writer) {
  if (!rough_case.report.stress_inside)
    return;
  const results::Result result = results::read_result(writer.path());
  for (const results::MethodRecord& record : result.methods) {
    const auto method =
        std::find_if(methods.begin(), methods.end(),
                     [&](const auto& one) { return one.name == record.name; });
    if (method == methods.end() || record.realizations.empty())
      continue;
    std::vector<results::Fields> maps = record.realizations.front().fields;
    std::erase_if(maps, [](const auto& map) { return !has_maps(map); });
    if (maps.empty())
      continue;
    const contact::ElasticBlock block =
        continuum_of(*method, rough_case.material, scales);
    const results::Table table =
        stress_table(method->name, block, maps, threads);
    writer.record_table(table);
    const auto heaviest = std::max_element(
        maps.begin(), maps.end(), [](const auto& a, const auto& b) {
          return a.nominal_pressure < b.nominal_pressure;
        });
    const auto row = static_cast<std::size_t>(heaviest - maps.begin());
    writer.record_table(stress_section(
        method->name, block, *heaviest,
        {table.values("von_mises")[row], table.values("depth")[row],
         heaviest->grid.index(
             static_cast<int>(std::lround(table.values("x")[row] /
                                          heaviest->grid.spacing_x())),
             static_cast<int>(std::lround(table.values("y")[row] /
                                          heaviest->grid.spacing_y())))},
        threads));
  }
}

} // namespace asperity::app
