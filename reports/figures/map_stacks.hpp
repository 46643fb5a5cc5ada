#pragma once

// This file makes the maps of a figure that the browser shows. It is internal
// to the figures.

#include "reports/analysis/summary.hpp"
#include "reports/explore/map_stack.hpp"
#include "results/types/result.hpp"

#include <vector>

namespace asperity::reports {

/// Returns an empty stack of maps on this grid.
MapStack stack_on(const Grid& grid);

/// Packs a map, divided by `unit`, for the browser.
/// @param most  largest number of points per side
PackedMap add_map(MapStack& stack, const Grid& grid,
                  const std::vector<double>& map, double unit, int most);

/// Returns the pressure and gap maps of up to twelve loads.
/// @param maps  at least one
MapStack contact_stack(const std::vector<const results::Fields*>& maps,
                       const SurfaceScales& scales);

/// Returns one height map in nm.
MapStack height_stack(const Grid& grid, const std::vector<double>& heights);

} // namespace asperity::reports
