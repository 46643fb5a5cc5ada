#pragma once

// Warnings about finite elements: volumetric locking, which makes them too
// stiff for nearly incompressible materials, and heights of a punch between the
// points of its map. Defines the limits on Poisson's ratio and the messages.

#include "input/types/case.hpp"

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

/// Returns one sentence for each full block on a punch whose contact points lie
/// between the points of the map: nodes of a mesh by gmsh or from a file. There
/// the interpolated heights overshoot the step at the edge of the end, so that
/// it touches there only.
std::vector<std::string>
interpolation_warnings(const Case& contact_case,
                       std::span<const MethodSpec> methods);

/// Returns the warnings above and omission_warnings() about the methods of a
/// run.
std::vector<std::string> warnings_about(const Case& contact_case,
                                        std::span<const MethodSpec> methods);

} // namespace asperity::cases
