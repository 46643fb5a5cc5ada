#pragma once

// From a state to the nearest balance of forces by Newton's method. Owns how
// far the second derivatives are believed.

#include "md/minimise/curved_system.hpp"
#include "md/minimise/relaxation.hpp"

#include <vector>

namespace asperity::md {

/// Inexact Newton's method from `state`, which it overwrites with the answer:
/// each step is what preconditioned conjugate gradients find of
/// (K + H) step = forces, K the bulk's second derivatives and H the
/// interface's, then brought down in energy as relax() does. Where conjugate
/// gradients meet negative curvature, or the step no way down, H is made less
/// soft (CurvedSystem::limit_softness) and solved for again; each good step
/// doubles what is allowed. No atom moves by more than largest_step at a time,
/// each shortened alone: one on its way down a slope does not hold up the rest.
///
/// The balance is that of relax(), which takes over where this gives up.
/// `memory` and `contact_stiffness` are for then alone.
/// @see  T. Steihaug, SIAM J. Numer. Anal. 20, 626 (1983);
///       S. C. Eisenstat and H. F. Walker, SIAM J. Sci. Comput. 17, 16 (1996)
Relaxation relax_by_newton(CurvedSystem& system, std::vector<double>& state,
                           const RelaxationSettings& settings,
                           const Watch& watch = {});

} // namespace asperity::md
