#pragma once

// Which waves of a grid look alike on the grid of half the points a side, in
// the half spectra of both. Owns the bookkeeping of conjugates.

#include "base/grid.hpp"

#include <array>
#include <cstddef>

namespace asperity::md {

/// A mode of a half spectrum, or the conjugate of one.
struct HalfMode {
  std::size_t index = 0; ///< into the half spectrum
  bool is_conjugate = false;
};

/// The mode (jx, jy) of the full spectrum, each any non-negative number.
inline HalfMode half_mode(const Grid& grid, int jx, int jy) {
  int x = jx % grid.points_x;
  int y = jy % grid.points_y;
  const bool is_conjugate = x > grid.points_x / 2;
  if (is_conjugate) {
    x = grid.points_x - x;
    y = (grid.points_y - y) % grid.points_y;
  }
  const auto columns = static_cast<std::size_t>(grid.points_x / 2 + 1);
  return {static_cast<std::size_t>(y) * columns + static_cast<std::size_t>(x),
          is_conjugate};
}

/// The four modes of the fine grid that are (jx, jy) on the coarse one.
inline std::array<HalfMode, 4> aliases(const Grid& fine, int jx, int jy) {
  const int x = jx + fine.points_x / 2;
  const int y = jy + fine.points_y / 2;
  return {half_mode(fine, jx, jy), half_mode(fine, x, jy),
          half_mode(fine, jx, y), half_mode(fine, x, y)};
}

} // namespace asperity::md
