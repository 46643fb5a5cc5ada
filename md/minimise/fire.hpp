#pragma once

// The other minimiser: damped motion that speeds up downhill and stops at every
// rise. Owns its time step and its mixing.

#include "md/minimise/relaxation.hpp"
#include "md/minimise/system.hpp"

#include <vector>

namespace asperity::md {

/// FIRE from `state`, which it overwrites with the answer: E. Bitzek et al.,
/// Phys. Rev. Lett. 97, 170201 (2006), its constants, with half a step taken
/// back at a rise (J. Guenole et al., Comput. Mater. Sci. 175, 109584 (2020)).
///
/// The mass matrix is P^-1, P of System::precondition: then every wave of the
/// crystal swings with a frequency near 1 and the time step has no unit. Sizes
/// of velocity and force are those of P^-1 and P, so the mixing stays Bitzek's.
/// settings.memory is not used.
Relaxation relax_by_fire(const System& system, std::vector<double>& state,
                         const RelaxationSettings& settings,
                         const Watch& watch = {});

} // namespace asperity::md
