#pragma once

// What a whole block costs before it is solved. Owns the model of Newton's
// steps, linear iterations and memory, and its measured constants.

#include "app/plan/cost_model.hpp"

namespace asperity::app {

/// Loading deal.II, on the reference machine of cost_model.cpp, CPU time [s].
inline constexpr double fem_load_time = 0.25;

/// By how much a prediction of a whole block may be off, either way [1]: what
/// docs/skip.md shows of iterations that depend on load, contact and moduli.
inline constexpr double block_factor = 3.0;

/// Of one method with solver = "full", or of a condensed one as if it were
/// whole. NaN where the mesh is a file.
MethodCost cost_of_full_block(const cases::Case& rough_case,
                              const cases::FemSettings& settings,
                              const Grid& grid, MachineRates& rates);

/// Of deal.II and Trilinos at work on any whole block, on top of their being
/// loaded [B].
double full_block_memory();

} // namespace asperity::app
