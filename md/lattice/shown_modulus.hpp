#pragma once

// The contact modulus an explicit block really shows. Owns the strip it is
// measured on.

#include "md/lattice/crystal.hpp"

namespace asperity::md {

/// E* = 2 / (q C) [Pa] that a pressure wave of q a near 0.1 meets on a block of
/// `levels` levels of `layers` layers of cells, C the displacement over the
/// pressure: solved exactly on a strip one wave long, q a as near to 0.1 as the
/// coarsest level allows.
/// @throws std::domain_error  as MultiscaleBlock
double shown_contact_modulus(const Crystal& crystal, int levels, int layers);

} // namespace asperity::md
