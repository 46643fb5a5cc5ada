#pragma once

// The FIRE minimiser: damped dynamics that accelerate downhill and stop
// whenever the energy would increase.

#include "md/minimise/relaxation.hpp"
#include "md/minimise/system.hpp"

#include <vector>

namespace asperity::md {

/// Minimises the energy from `state` by FIRE and overwrites `state` with the
/// solution. The algorithm and its constants are those of E. Bitzek et al.,
/// Phys. Rev. Lett. 97, 170201 (2006), with half a step taken back when the
/// motion turns uphill (J. Guenole et al., Comput. Mater. Sci. 175, 109584
/// (2020)).
///
/// The mass matrix is P^-1, with P as in System::precondition(). All modes of
/// the crystal then have frequencies near 1, and the time step is
/// dimensionless. The norms of velocity and force are those induced by P^-1 and
/// P, which leaves the mixing rule unchanged. settings.memory is not used.
Relaxation relax_by_fire(const System& system, std::vector<double>& state,
                         const RelaxationSettings& settings,
                         const Watch& watch = {});

} // namespace asperity::md
