#pragma once

// The squares of a grid in which there is contact.

#include "base/grid.hpp"

#include <cstddef>
#include <vector>

namespace asperity::contact {

/// Nodes along the side of a tile.
inline constexpr int tile_points = 64;
inline constexpr std::size_t tile_side = tile_points;
inline constexpr std::size_t tile_nodes = tile_side * tile_side;

/// Whether a grid is divided into tiles: of equal spacings, and of an even
/// number of tiles in each direction, at least 8.
inline bool has_tiles(const Grid& grid) {
  const auto is_divided = [](int points) {
    return points % (2 * tile_points) == 0 && points >= 8 * tile_points;
  };
  return is_divided(grid.points_x) && is_divided(grid.points_y) &&
         is_same_length(grid.spacing_x(), grid.spacing_y());
}

/// Some tiles of a grid that has_tiles().
struct Tiles {
  int per_row = 0, per_column = 0; ///< of the grid
  bool is_periodic = true;       ///< whether there are tiles beyond the border
  std::vector<int> numbers = {}; ///< row by row, in rising order

  /// The number of a tile that may lie outside, on the periodic continuation;
  /// -1 if there is none.
  int number(int tx, int ty) const {
    const bool is_outside =
        tx < 0 || tx >= per_row || ty < 0 || ty >= per_column;
    if (is_outside && !is_periodic)
      return -1;
    return (ty + per_column) % per_column * per_row + (tx + per_row) % per_row;
  }
};

} // namespace asperity::contact
