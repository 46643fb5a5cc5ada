#pragma once

// Converts the settings of a case to a problem instance, which `asperity
// robustness CASE` perturbs.

#include "cases/types/case.hpp"
#include "robustness/instance.hpp"

namespace asperity::robustness {

/// Uses the length, spectrum and slope of the surface, the modulus, and the
/// block, contact law and penalty of the case's first method that has them.
/// Grid and load are drawn at random later. A surface that is not self-affine
/// is represented by its statistics: by its slope, and by waves down to eight
/// node spacings.
/// @throws input::InputError  the surface cannot be built
Instance instance_of_case(const cases::Case& contact_case);

} // namespace asperity::robustness
