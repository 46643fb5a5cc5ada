#pragma once

// A solved step as a row of the curve: every elastic method is read by the
// same observables.

#include "app/elastic_method.hpp"
#include "results/result.hpp"

namespace asperity::app {

/// Everything but the times and the stiffness, which is the curve's.
results::CurvePoint curve_row(const contact::ContactSolution& solution,
                              const StepSolver& solver,
                              const MethodDescription& method,
                              const SurfaceOfCase& surface);

} // namespace asperity::app
