#pragma once

// The Winkler foundation as a method of a run.

#include "app/methods/step_solver.hpp"
#include "app/methods/surfaces_of_case.hpp"
#include "cases/types/methods.hpp"

#include <memory>

namespace asperity::app {

MethodDescription describe(const mechanics::WinklerSettings& settings);

/// @param surface  must outlive the solver
std::unique_ptr<StepSolver>
make_winkler_solver(const mechanics::WinklerSettings& settings,
                    const SurfaceOfCase& surface);

} // namespace asperity::app
