#include "run/methods/stress_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::methods {
namespace {

constexpr int section_rows = 49; ///< depths of a section, including the surface
constexpr int section_columns = 257;      ///< upper limit
constexpr double section_depth = 4.0;     ///< multiple of the depth of the
                                          ///< strongest point
constexpr double section_reach = 1.5;     ///< half-width as a multiple of the
                                          ///< section depth
constexpr std::size_t most_sections = 12; ///< loads of one table
constexpr double below_layers = 1.5; ///< minimum depth as a multiple of the
                                     ///< layer thickness

/// Returns the depth of the section in a block of unlimited thickness [m].
double depth_of_section(const mechanics::ElasticBlock& block,
                        double peak_depth) {
  double layers = 0.0;
  for (const mechanics::BondedLayer& layer : block.layers)
    layers += layer.thickness;
  return std::max(section_depth * peak_depth, below_layers * layers);
}

/// Returns the nodes of a section along x as offsets from the strongest point.
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

/// Assembles the table of a section.
///
/// @param origin    description of where the numbers come from
/// @param x         position of each column relative to the strongest point [m]
/// @param strength  von Mises stress, one row per depth, x fastest [Pa]
results::Table section_table(const std::string& method, double pressure,
                             const std::string& origin,
                             const std::vector<double>& depths,
                             const std::vector<double>& x,
                             const std::vector<double>& strength) {
  results::Table table{
      "stress-section-" + method,
      fmt::format(
          "Von Mises stress below the contact surface at p = {:.6g} Pa, {}, {}",
          pressure, method, origin),
      {{"depth", "m"}, {"x", "m"}, {"von_mises", "Pa"}}};
  std::size_t next = 0;
  for (const double depth : depths)
    for (const double place : x)
      table.add({depth, place, strength[next++]});
  return table;
}

/// Von Mises stress under a map [Pa], one row per depth, x fastest.
std::vector<double> strength_at(const SectionPlaces& places,
                                const StressUnderMaps& stress,
                                const results::Fields& map,
                                const contact::StressPeak& peak) {
  const Grid& grid = map.grid;
  const int peak_x = static_cast<int>(peak.node) % grid.points_x;
  const int peak_y = static_cast<int>(peak.node) / grid.points_x;
  std::vector<double> strength;
  for (const std::vector<double>& row :
       stress.von_mises_rows(map, places.depth, peak_y))
    for (const int offset : places.offsets) {
      const int ix = (peak_x + offset + grid.points_x) % grid.points_x;
      strength.push_back(row[static_cast<std::size_t>(ix)]);
    }
  return strength;
}

std::vector<double> in_metres(const std::vector<int>& offsets, double spacing) {
  std::vector<double> places;
  places.reserve(offsets.size());
  for (const int offset : offsets)
    places.push_back(offset * spacing);
  return places;
}

} // namespace

contact::StressInside
StressUnderMaps::inside(const results::Fields& map) const {
  return {map.grid, block_, map.pressure_map().whole(), threads_};
}

StressPoint StressUnderMaps::strongest(const results::Fields& map) const {
  const contact::StressInside found = inside(map);
  const contact::StressPeak peak = found.strongest();
  return {peak, found.shear_at(peak)};
}

std::vector<std::vector<double>>
StressUnderMaps::von_mises_rows(const results::Fields& map,
                                std::span<const double> depths, int row) const {
  const contact::StressInside found = inside(map);
  std::vector<std::vector<double>> rows;
  for (const double depth : depths)
    rows.push_back(found.von_mises_row(depth, row));
  return rows;
}

SectionPlaces section_places(const Grid& grid,
                             const mechanics::ElasticBlock& block,
                             double peak_depth) {
  const double whole_depth = depth_of_section(block, peak_depth);
  const double deepest = std::min(whole_depth, block.thickness);
  SectionPlaces places{{}, offsets_of(grid, whole_depth)};
  for (int row = 0; row < section_rows; ++row)
    places.depth.push_back(deepest * row / (section_rows - 1));
  return places;
}

results::Table stress_section(const std::string& method,
                              const StressUnderMaps& stress,
                              const results::Fields& map,
                              const contact::StressPeak& peak) {
  const SectionPlaces places =
      section_places(map.grid, stress.block(), peak.depth);
  return section_table(method, map.nominal_pressure, "from its pressure",
                       places.depth,
                       in_metres(places.offsets, map.grid.spacing_x()),
                       strength_at(places, stress, map, peak));
}

results::Table stress_sections(const std::string& method,
                               const StressUnderMaps& stress,
                               std::span<const results::Fields> maps,
                               const contact::StressPeak& peak) {
  const Grid& grid = maps.front().grid;
  const SectionPlaces places = section_places(grid, stress.block(), peak.depth);
  results::Table table{"stress-sections-" + method,
                       "Von Mises stress in that plane at the saved loads, " +
                           method,
                       {{"nominal_pressure", "Pa"},
                        {"depth", "m"},
                        {"x", "m"},
                        {"von_mises", "Pa"}}};
  const std::size_t n_used = std::min(maps.size(), most_sections);
  for (std::size_t k = 0; k < n_used; ++k) {
    const results::Fields& map =
        maps[n_used == 1 ? 0 : k * (maps.size() - 1) / (n_used - 1)];
    const std::vector<double> of_map = strength_at(places, stress, map, peak);
    std::size_t next = 0;
    for (const double depth : places.depth)
      for (const int offset : places.offsets)
        table.add({map.nominal_pressure, depth, offset * grid.spacing_x(),
                   of_map[next++]});
  }
  return table;
}

results::Table stress_section(const OwnSection& section,
                              const fem::FullBlock& block,
                              const mechanics::ElasticBlock& continuum) {
  const Grid& grid = block.grid();
  const fem::StressPeak& peak = section.peak;
  SectionPlaces places =
      section_places(grid, continuum, std::max(peak.depth, grid.spacing_x()));
  const auto at = [&](int offset) {
    return peak.place[0] + offset * grid.spacing_x();
  };
  if (!section.is_periodic)
    std::erase_if(places.offsets, [&](int offset) {
      return at(offset) < 0.0 || at(offset) > grid.length_x;
    });
  fem::SectionPlane plane{peak.place[1],
                          peak.place[2] < 0.0 && !section.has_counter,
                          {},
                          places.depth};
  for (const int offset : places.offsets)
    plane.x.push_back(at(offset) -
                      grid.length_x * std::floor(at(offset) / grid.length_x));
  std::vector<double> depths = places.depth;
  std::vector<double> strength = block.section(plane);
  if (section.has_counter) {
    plane.is_counter = true;
    plane.depth = {places.depth.rbegin(), places.depth.rend() - 1};
    const std::vector<double> above = block.section(plane);
    strength.insert(strength.begin(), above.begin(), above.end());
    for (double& depth : plane.depth)
      depth = -depth;
    depths.insert(depths.begin(), plane.depth.begin(), plane.depth.end());
  }
  return section_table(section.method, section.nominal_pressure,
                       "from its cells", depths,
                       in_metres(places.offsets, grid.spacing_x()), strength);
}

} // namespace asperity::methods
