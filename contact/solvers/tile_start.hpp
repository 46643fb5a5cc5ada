#pragma once

#include "contact/solvers/contact_state.hpp"

namespace asperity::contact {

/// Lowers the error of a state whose contact covers a small part of the
/// surface, by iterations on the tiles that have contact (docs/numerics/
/// solver.md). Does nothing if the contact covers more, with a prescribed gap,
/// with a hardness, or if the operator has no form on tiles. Collective.
void approach_on_tiles(ContactState& state);

/// Improves a start by the solution of the problem on the tiles that have
/// contact. Collective.
/// @param gap_tolerance  of this solution [m]
/// @param start          > 0 in contact; overwritten by a pressure >= 0 [Pa] of
///                       the target
/// @return  false under the conditions above, or if the solution failed; the
///          start is then unchanged
bool start_on_tiles(const SurfaceOperator& elasticity,
                    const ContactProblem& problem,
                    const mechanics::LoadTarget& target, double gap_tolerance,
                    std::span<double> start);

} // namespace asperity::contact
