#pragma once

// Warnings about volumetric locking: finite elements that are too stiff for
// nearly incompressible materials. Defines the limits on Poisson's ratio and
// the messages.

#include "cases/types/case.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::cases {

/// Returns Poisson's ratio from which on a wave with eight nodes per wavelength
/// is too stiff by more than a tenth (Q1) or a twentieth (Q2), as measured in
/// tests/fem/locking_test.cpp.
double locking_ratio(mechanics::Element element);

/// Returns one sentence for each [fem] method with a material above the limit
/// of its element: the method, the error in stiffness and a remedy.
std::vector<std::string>
locking_warnings(const mechanics::MaterialSpec& material,
                 std::span<const MethodSpec> methods);

} // namespace asperity::cases
