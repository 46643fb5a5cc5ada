#pragma once

// [fem] with solver = "full": the whole three-dimensional block behind one
// load step after another.

#include "app/methods/step_solver.hpp"
#include "app/methods/surfaces_of_case.hpp"
#include "cases/types/case.hpp"

#include <filesystem>
#include <memory>

namespace asperity::app {

/// Steps of the first realisation whose maps are kept leave files for ParaView
/// where the case asks, and the heaviest of them a section.
/// @param surface  the method's own; outlives the solver
/// @param scratch  folder of the files, made when needed
/// @throws std::domain_error, cases::CaseError  the mesh cannot be made or is
///                                              refused, in words
std::unique_ptr<StepSolver>
make_whole_block(const cases::Case& rough_case, const cases::MethodSpec& method,
                 const SurfaceOfCase& surface, int realization,
                 const std::filesystem::path& scratch);

} // namespace asperity::app
