#pragma once

// The block of a method as a continuum: half-space, slab, and the layers of the
// case on it.

#include "cases/types/case.hpp"
#include "contact/operators/halfspace.hpp"

namespace asperity::app {

/// What the half-space presses, and what stresses inside are worked out in:
/// half-space or slab as the method has it, with the case's layers; atoms are a
/// half-space without. Under layers the moduli are the block's own, else those
/// of the pair if there is a counter body.
contact::ElasticBlock continuum_of(const cases::MethodSpec& method,
                                   const cases::MaterialSpec& material,
                                   const cases::Scales& scales);

/// E* [Pa] that the rim of a contact feels: of the block without layers; under
/// layers 2/(C q) of waves four spacings long, which is the coating's where
/// that is thicker than a spacing or two.
double rim_modulus(const contact::ElasticBlock& block, double spacing);

} // namespace asperity::app
