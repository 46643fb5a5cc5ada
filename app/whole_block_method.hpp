#pragma once

// [fem] with solver = "full": the whole three-dimensional block behind one
// load step after another.

#include "app/step_solver.hpp"
#include "app/surfaces_of_case.hpp"
#include "cases/case.hpp"

#include <memory>
#include <string>

namespace asperity::app {

/// Steps whose maps are kept leave files for ParaView where the case asks.
/// @param surface  the method's own; outlives the solver
/// @param files    folder and stem of these; empty for none
/// @throws std::domain_error, cases::CaseError  the mesh cannot be made or is
///                                              refused, in words
std::unique_ptr<StepSolver> make_whole_block(const cases::Case& rough_case,
                                             const cases::MethodSpec& method,
                                             const SurfaceOfCase& surface,
                                             const std::string& files);

} // namespace asperity::app
