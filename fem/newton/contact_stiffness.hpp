#pragma once

// The stiffness of a contact: reactions to a unit displacement of its nodes.
// Include this header in .cpp files of fem/ only.

#include "fem/newton/contact_state.hpp"

namespace asperity::fem {

/// As FullBlock::stiffness(), of nodes that touch. Collective.
ContactStiffness contact_stiffness(const BlockSystem& system,
                                   BlockSolver& solver,
                                   const ContactSet& touching);

} // namespace asperity::fem
