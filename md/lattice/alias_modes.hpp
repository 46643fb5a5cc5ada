#pragma once

// Maps the modes of a lateral grid to the modes of the grid with half as many
// points per side. It determines which fine modes alias to the same coarse
// mode, in the half spectra of both grids, and handles complex conjugates.

#include "base/grid.hpp"

#include <array>
#include <cstddef>

namespace asperity::md {

/// A mode of a half spectrum, or the conjugate of such a mode.
struct HalfMode {
  std::size_t index = 0; ///< index into the half spectrum
  bool is_conjugate = false;
};

/// Returns the entry of the half spectrum that represents the mode (jx, jy) of
/// the full spectrum. Both numbers may be any non-negative integers.
inline HalfMode half_mode(const Grid& grid, int jx, int jy) {
  int x = jx % grid.points_x;
  int y = jy % grid.points_y;
  const bool is_conjugate = x > grid.points_x / 2;
  if (is_conjugate) {
    x = grid.points_x - x;
    y = (grid.points_y - y) % grid.points_y;
  }
  const std::size_t columns = grid.half_spectrum_columns();
  return {static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x),
          is_conjugate};
}

/// Returns the four modes of the fine grid that alias to the mode (jx, jy) of
/// the coarse grid.
inline std::array<HalfMode, 4> aliases(const Grid& fine, int jx, int jy) {
  const int x = jx + fine.points_x / 2;
  const int y = jy + fine.points_y / 2;
  return {half_mode(fine, jx, jy), half_mode(fine, x, jy),
          half_mode(fine, jx, y), half_mode(fine, x, y)};
}

} // namespace asperity::md
