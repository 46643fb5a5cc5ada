#pragma once

// The effective contact modulus of an explicit block, computed on a periodic
// strip.

#include "md/lattice/crystal.hpp"

namespace asperity::md {

/// Returns the effective contact modulus E* = 2 / (q C) [Pa] of a block with
/// `levels` levels of `layers` layers of cells for a sinusoidal pressure with
/// q a close to 0.1, where C is the ratio of displacement to pressure. The
/// response is solved exactly on a strip one wavelength long; q a is as close
/// to 0.1 as the coarsest level allows.
/// @throws std::domain_error  as the constructor of MultiscaleBlock
double effective_contact_modulus(const Crystal& crystal, int levels,
                                 int layers);

} // namespace asperity::md
