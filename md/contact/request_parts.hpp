#pragma once

// What a request says, in the words of the parts that compute.

#include "md/contact/atomic_contact.hpp"
#include "md/interface/interaction.hpp"
#include "md/lattice/crystal.hpp"

namespace asperity::md {

/// A step starts this far over the highest substrate atom where no earlier
/// step was solved [m].
inline constexpr double start_clearance = 4e-10;

Crystal crystal_of(const AtomRequest& request);

/// The taper begins at 0.9 of the cut-off.
Interaction interaction_of(const cases::MdSettings& settings);

/// Two atoms nearer than this have gone through each other: 2.2 angstrom for
/// the paper's r_0 = 3.28 angstrom.
double close_distance(const cases::MdSettings& settings);

} // namespace asperity::md
