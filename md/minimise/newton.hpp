#pragma once

// An inexact Newton method for the equilibrium of forces.

#include "md/minimise/curved_system.hpp"
#include "md/minimise/relaxation.hpp"

#include <vector>

namespace asperity::md {

/// Minimises the energy from `state` by an inexact Newton method and overwrites
/// `state` with the solution. Each step is the approximate solution of
/// (K + H) step = forces by preconditioned conjugate gradients, where K and H
/// are the second derivatives of the bulk and of the interface, followed by a
/// line search as in relax(). If conjugate gradients encounter negative
/// curvature, or if the line search fails, the negative curvature of H is
/// reduced (CurvedSystem::limit_negative_curvature) and the system is solved
/// again; each accepted step relaxes this limit. No atom moves by more than
/// largest_step per step. The displacement of each atom is limited separately,
/// so that a single atom sliding down a slope does not shorten the step of the
/// others.
///
/// The convergence criterion is that of relax(), which takes over if no step
/// can be found. `memory` and `contact_stiffness` are used only in that case.
/// @see  T. Steihaug, SIAM J. Numer. Anal. 20, 626 (1983);
///       S. C. Eisenstat and H. F. Walker, SIAM J. Sci. Comput. 17, 16 (1996)
Relaxation relax_by_newton(CurvedSystem& system, std::vector<double>& state,
                           const RelaxationSettings& settings,
                           const Watch& watch = {});

} // namespace asperity::md
