#pragma once

// Converts an AtomRequest to the arguments of the components of this module.

#include "md/contact/atomic_contact.hpp"
#include "md/interface/interaction.hpp"
#include "md/lattice/crystal.hpp"

namespace asperity::md {

/// Initial distance of the block above the highest substrate atom if no earlier
/// step was solved [m].
inline constexpr double start_clearance = 4e-10;

Crystal crystal_of(const AtomRequest& request);

/// Returns the pair potential. Its taper begins at 0.9 of the cutoff.
Interaction interaction_of(const mechanics::MdSettings& settings);

/// Returns the distance below which two atoms are considered to have penetrated
/// each other: 2.2 angstrom for r_0 = 3.28 angstrom of Yang and Persson (2008).
double close_distance(const mechanics::MdSettings& settings);

} // namespace asperity::md
