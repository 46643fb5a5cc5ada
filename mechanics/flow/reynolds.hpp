#pragma once

// Flow of a thin viscous film through the gap of a contact, by Reynolds'
// equation div(u^3 grad P) = 0, and the narrowest place of its widest path.

#include "base/grid.hpp"
#include "mechanics/contact_nodes.hpp"
#include "mechanics/flow/network.hpp"

#include <span>
#include <vector>

namespace asperity::flow {

/// Direction of the mean flow. The map is a piece of the seal of its full
/// length in this direction, between two reservoirs. Across, it continues
/// periodically, or ends at insulated sides where its border is free.
enum class Direction { x, y };

/// The flow through one map.
struct GapFlow {
  /// Whether open nodes join the reservoirs by their four neighbours. If not,
  /// all other numbers are 0.
  bool percolates = false;
  /// Q 12 eta/Dp [m^3], where Q [m^3/s] is the flow through the map.
  double conductance = 0.0;
  /// phi = (Q/W) 12 eta L/(u^3 Dp) with the mean open gap u over the whole map
  /// of length L along the flow and width W [1].
  double flow_factor = 0.0;
  /// The largest gap that some path between the reservoirs nowhere falls below
  /// [m], and the node where this path is narrowest.
  double critical_gap = 0.0;
  int critical_x = 0, critical_y = 0;
  /// Largest difference of the flow through two sections, over the flow [1].
  double imbalance = 0.0;
  int iterations = 0;
  /// |q| of each node over the mean flow per width Q/W [1], 0 where nothing
  /// flows; grid.size() values, or none if it was not asked for.
  std::vector<double> flux = {};
};

/// Computes the flow through a gap. Finite volumes: each node has a cell of the
/// grid, and the conductance of a face is the harmonic mean of u^3 of its two
/// cells, which is exact for resistances in series, where the pressure drops;
/// the reservoirs are at the outer faces of the first and last cells. The flow
/// is that of the dissipation, whose error is of second order in that of P.
///
/// @param gap       u [m], grid.size() values; closed where <= 0, as
///                  mechanics::ContactNodes::open_gaps() has it
/// @param solve     solves the network
/// @param has_flux  whether the answer has the flux of each node
/// @throws std::domain_error   the size of the map is not that of the grid, or
///                             the grid has fewer than 3 points per side
/// @throws std::runtime_error  the network was not solved
/// @par Accuracy  second order in the spacing (tests/flow/reynolds_test.cpp)
GapFlow flow_through(const Grid& grid, std::span<const double> gap,
                     Direction direction, mechanics::Border border,
                     const SolveNetwork& solve, bool has_flux = false);

} // namespace asperity::flow
