#pragma once

// Computes the power of the Fourier modes of a map. It defines the
// normalisation on a grid and the treatment of Nyquist modes.

#include "surfaces/maps/height_map.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

namespace asperity::surfaces {

/// |q| of mode (jx, jy) of the half spectrum of a grid [rad/m]; equal for
/// (jx, jy) and (jx, points_y - jy).
inline double mode_wavevector(const Grid& grid, int jx, int jy) {
  return std::hypot(
      wavevector(jx, grid.length_x),
      wavevector(signed_wavenumber(jy, grid.points_y), grid.length_y));
}

/// Calls take(jx, power) for columns jx of the half spectrum of a map, with the
/// power of its modes jy = 0..points_y-1: that of both modes of a pair q, -q of
/// which the half spectrum has one, and 0 for q = 0. With
///
///     a_q = (1/N) sum_x h(x) exp(-i q.x),
///     sum_{q != 0} |a_q|^2 = <h^2> - <h>^2
///
/// The second line, Parseval's theorem over the nodes, holds to roundoff. A
/// Nyquist mode, of wavenumber n/2 along a side of even n, represents +n/2 and
/// -n/2 alike: its whole power is counted once, under |q| with pi/spacing along
/// that side, which is the same for both. Slopes and curvatures computed from
/// q^2 |a_q|^2 thus include it with this wavevector. Realised random surfaces
/// have no Nyquist modes; in measured maps they are noise.
void each_column(
    const HeightMap& map,
    const std::function<void(int jx, std::span<const double> power)>& take);

/// The same of a map that is passed on by pieces, with the same bits. Columns
/// are taken in their order. The pieces are read several times, so that columns
/// of 64 MB, or an eighth of the map if that is more, are in memory.
void each_column(
    const Grid& grid, const HeightRows& heights, int threads,
    const std::function<void(int jx, std::span<const double> power)>& take);

/// Number of modes, q and -q, that one value of column jx stands for: column 0
/// and an even Nyquist column hold both modes of a pair.
inline int modes_in_column(const Grid& grid, int jx) {
  return jx == 0 || 2 * jx == grid.points_x ? 1 : 2;
}

} // namespace asperity::surfaces
