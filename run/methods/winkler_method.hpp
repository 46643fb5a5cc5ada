#pragma once

// The Winkler foundation as a method of a run.

#include "input/types/methods.hpp"
#include "run/methods/step_solver.hpp"
#include "run/methods/surfaces_of_case.hpp"

#include <memory>

namespace asperity::methods {

MethodDescription describe(const mechanics::WinklerSettings& settings);

/// @param surface  must outlive the solver
std::unique_ptr<StepSolver>
make_winkler_solver(const mechanics::WinklerSettings& settings,
                    const SurfaceOfCase& surface);

} // namespace asperity::methods
