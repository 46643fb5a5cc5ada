#pragma once

// The power of a map's Fourier modes. Owns the normalisation on a grid and the
// one treatment of Nyquist modes.

#include "surfaces/maps/height_map.hpp"

#include <functional>

namespace asperity::surfaces {

/// The modes q and -q of a map, or one mode that is its own opposite.
struct ModePower {
  double wavevector = 0.0; ///< |q| [rad/m] > 0
  double power = 0.0;      ///< sum of |a_q|^2 over them [m^2]
  int modes = 0;           ///< 1 or 2
};

/// Calls `take` once for each pair q, -q of the map but not for q = 0, with
///
///     a_q = (1/N) sum_x h(x) exp(-i q.x),   sum_{q != 0} |a_q|^2 = <h^2> -
///     <h>^2
///
/// the latter (Parseval) to rounding, over the nodes. A Nyquist mode, of
/// wavenumber n/2 along a side of even n, is as much +n/2 as -n/2: its whole
/// power is booked once, under |q| with pi/spacing along that side, which is
/// the same for either. Slopes and curvatures made of q^2 |a_q|^2 thus include
/// it as that wave. Realised surfaces have none; in measured maps it is noise.
void for_each_mode(const HeightMap& map,
                   const std::function<void(const ModePower&)>& take);

} // namespace asperity::surfaces
