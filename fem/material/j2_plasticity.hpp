#pragma once

// Plastic flow of metals. This header does not depend on deal.II.

#include <memory>

namespace asperity::fem {

class MaterialLaw;

/// Small-strain J2 plasticity with isotropic, linear hardening. Its quantities
/// are `plastic_work`, the work of plastic flow so far [J/m^2], and
/// `plastic_strain`, the largest equivalent plastic strain [1], the integral of
/// sqrt(2/3) |d plastic strain|.
/// @param yield_stress  in uniaxial tension [Pa] > 0
/// @param hardening     its increase per equivalent plastic strain [Pa] >= 0
std::shared_ptr<const MaterialLaw> j2_plasticity(double yield_stress,
                                                 double hardening);

} // namespace asperity::fem
