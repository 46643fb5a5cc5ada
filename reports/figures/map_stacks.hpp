#pragma once

// Makes the maps of a figure that the browser shows. It is internal to the
// figures.

#include "reports/explore/map_stack.hpp"
#include "reports/figures/plot_parts.hpp"
#include "results/types/result.hpp"

#include <span>
#include <vector>

namespace asperity::reports {

/// Returns an empty stack of maps on this grid.
MapStack stack_on(const Grid& grid);

/// Packs a map, divided by `unit`, for the browser.
/// @param most  largest number of points per side
PackedMap add_map(MapStack& stack, const Grid& grid,
                  const results::MapView& map, double unit, int most);

/// The same of a map that is already reduced.
PackedMap add_reduced(MapStack& stack, ReducedMap small, double unit);

/// The units in which pressure and gap maps are shown first, physical or
/// reduced.
struct MapUnits {
  double pressure = 0.0;                    ///< [Pa]
  double gap = 0.0;                         ///< [m]
  bool has_tension = false;                 ///< of a size that colours can show
  std::vector<MapQuantity> quantities = {}; ///< pressure, contact and gap
};

/// @param maps  at least one
MapUnits map_units(std::span<const results::Fields> maps,
                   const FigureScales& scales);

/// Returns the maps of pressure, contact and gap of up to twelve loads.
/// @param maps  at least one
MapStack contact_stack(std::span<const results::Fields> maps,
                       const FigureScales& scales, const MapUnits& units,
                       const mechanics::ContactCriterion& criterion);

/// Returns one height map in nm.
MapStack height_stack(const Grid& grid, const results::MapView& heights);

} // namespace asperity::reports
