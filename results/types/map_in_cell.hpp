#pragma once

// The user's map in the cell that a solver presses.

#include "base/grid.hpp"
#include "results/types/map_view.hpp"

#include <cstddef>

namespace asperity::results {

/// Where the user's map is in the cell that a solver presses. A measured map
/// that continues by its mirror images is the first columns and rows of a cell
/// of four times its area; any other map is the whole cell. This is the only
/// place that knows the difference: extensive numbers of a row
/// (state_of_map() in curve_columns.hpp), maps that are shown, and the nominal
/// area follow from it.
struct MapInCell {
  int columns = 0; ///< of the map; 0: the map is the whole cell
  int rows = 0;    ///< likewise

  bool is_whole(const Grid& cell) const {
    return columns <= 0 || rows <= 0 ||
           (columns >= cell.points_x && rows >= cell.points_y);
  }

  /// The grid of the map.
  Grid grid(const Grid& cell) const {
    return is_whole(cell) ? cell
                          : Grid{columns, rows, columns * cell.spacing_x(),
                                 rows * cell.spacing_y()};
  }

  /// The area of the map over that of the cell [1]: 1 or 1/4.
  double share(const Grid& cell) const {
    return static_cast<double>(grid(cell).size()) /
           static_cast<double>(cell.size());
  }

  /// The same part of another grid on that cell; where the border of the map
  /// is between two nodes, the map has the first.
  /// @param cell   with this map
  /// @param other  of the same lengths
  MapInCell on(const Grid& cell, const Grid& other) const;

  /// The node of the map of which a node of the cell is an image, or itself.
  std::size_t node_on_map(std::size_t node, const Grid& cell) const;

  /// The values of the map, of which `values` has those of the cell. These must
  /// outlive the result, which is empty if they do not fill the cell.
  StoredMap of(const MapView& values, const Grid& cell) const;

  friend bool operator==(const MapInCell&, const MapInCell&) = default;
};

} // namespace asperity::results
