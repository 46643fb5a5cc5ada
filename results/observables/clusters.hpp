#pragma once

// The clusters of a map: spots of contact, or the connected parts of the gap.

#include "results/observables/observables.hpp"
#include "results/types/map_in_cell.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace asperity::results {

/// A set of nodes that are joined by their four neighbours.
struct Cluster {
  std::size_t nodes = 0;
  double area = 0.0;     ///< of the cells of its nodes [m^2]
  double map_area = 0.0; ///< the part of it on the user's map [m^2]
  /// Length of the edges between its cells and others [m], as
  /// contact_perimeter(): longer than a smooth curve, by 4/pi on average.
  double perimeter = 0.0;
  /// Whether it surrounds the periodic map in x and y: following it returns to
  /// the same node a period further. With a free border: whether it joins the
  /// opposite sides.
  bool spans_x = false, spans_y = false;
};

/// Finds the clusters of the nodes inside a set, those across a periodic border
/// included. Two nodes are joined if they are neighbours in x or y, since cells
/// that share a corner alone exchange neither heat nor fluid:
/// mechanics/flow/reynolds.hpp joins the gap in the same way. Where four cells
/// meet as on a chessboard, neither the set nor its complement is thus joined.
///
/// @param is_inside  grid.size() values, 0 outside
/// @param map        the user's map in the grid
/// @return  in the order of their first nodes
/// @throws std::domain_error  the size of the map is not that of the grid
std::vector<Cluster> find_clusters(const Grid& grid,
                                   std::span<const std::uint8_t> is_inside,
                                   Border border, const MapInCell& map = {});

/// Numbers of all clusters of a set. Count and size are about the user's map:
/// a cluster that its border cuts counts once, with its part on the map, as it
/// does for someone who counts on the map itself, because a mirror image joins
/// nothing that is not joined on the map. The others are those of the cell.
struct ClusterNumbers {
  double count = 0.0;   ///< that have a part on the map
  double largest = 0.0; ///< area on the map of the largest one [m^2]
  /// D of perimeter ~ area^(D/2), by least squares of the logarithms over the
  /// clusters of at least `smallest` nodes that do not span the map: 1 for
  /// smooth ones, and about 2 for ragged ones whose parts are as wide as a
  /// cell. NaN: fewer than 10, or all of one size.
  double dimension = Observed::none;
  bool percolates_x = false, percolates_y = false; ///< whether any one spans
  /// Sum of the radii of circles of the same areas [m].
  double radii = 0.0;
};

ClusterNumbers cluster_numbers(std::span<const Cluster> clusters,
                               std::size_t smallest);

} // namespace asperity::results
