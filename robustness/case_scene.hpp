#pragma once

// The scene that a case's own settings make: what `asperity robustness CASE`
// perturbs.

#include "cases/types/case.hpp"

#include "robustness/scene.hpp"

namespace asperity::robustness {

/// Length, spectrum and slope of the surface, modulus, and block, law and
/// penalty of the case's first method that has them. Grid and load are left to
/// be drawn. A surface that is not self-affine is taken by its statistics: its
/// slope, and waves down to eight nodes.
/// @throws cases::CaseError  the surface cannot be built
Scene scene_of_case(const cases::Case& rough_case);

} // namespace asperity::robustness
