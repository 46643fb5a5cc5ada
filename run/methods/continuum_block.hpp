#pragma once

// The continuum model of the block of a method: a half-space or slab with the
// layers of the case.

#include "contact/operators/halfspace.hpp"
#include "input/types/case.hpp"

namespace asperity::methods {

/// Returns the block for the half-space solver and for the subsurface stress: a
/// half-space or slab as set for the method, with the layers of the case and
/// the border of the method. All that is stated of the operator of a method
/// follows from it.
/// Atomistic blocks become a half-space without layers. With layers the moduli
/// are those of the block itself; otherwise they are the combined moduli of the
/// pair if there is a second body.
mechanics::ElasticBlock continuum_of(const cases::MethodSpec& method,
                                     const mechanics::MaterialSpec& material,
                                     const mechanics::Scales& scales);

/// Returns the effective modulus E* [Pa] at the contact boundary. Without
/// layers it is that of the block. With layers it is 2/(C q) at a wavelength of
/// four grid spacings, which is the modulus of the coating if the coating is
/// thicker than one or two spacings.
double boundary_modulus(const mechanics::ElasticBlock& block, double spacing);

} // namespace asperity::methods
