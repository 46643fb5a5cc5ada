#pragma once

// The preconditioned iteration from a state to the solution.

#include "contact/solvers/contact_state.hpp"

namespace asperity::contact {

/// Solves the problem of a state, whose residual is known, by the method of
/// solve_contact(). Collective.
ContactSolution iterated(ContactState&& state);

} // namespace asperity::contact
