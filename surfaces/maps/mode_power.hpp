#pragma once

// This file computes the power of the Fourier modes of a map. It defines the
// normalisation on a grid and the treatment of Nyquist modes.

#include "surfaces/maps/height_map.hpp"

#include <functional>

namespace asperity::surfaces {

/// The modes q and -q of a map, or one mode that equals its opposite.
struct ModePower {
  double wavevector = 0.0; ///< |q| [rad/m] > 0
  double power = 0.0;      ///< sum of |a_q|^2 over these modes [m^2]
  int modes = 0;           ///< number of modes, 1 or 2
};

/// Calls `take` once for each pair q, -q of the map except q = 0, with
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
void for_each_mode(const HeightMap& map,
                   const std::function<void(const ModePower&)>& take);

} // namespace asperity::surfaces
