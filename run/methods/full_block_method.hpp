#pragma once

// [fem] with solver = "full": solves one load step after another with the full
// 3-D block.

#include "fem/plugin.hpp"
#include "input/types/case.hpp"
#include "run/methods/step_solver.hpp"
#include "run/methods/surfaces_of_case.hpp"

#include <memory>

namespace asperity::methods {

struct Resources;

/// What fem/ is asked for, without the mesh of a file.
/// @param grid  that the method presses
fem::FullRequest full_request(const cases::Case& contact_case,
                              const mechanics::FemSettings& settings,
                              const Grid& grid,
                              const mechanics::Scales& scales);

/// Creates the solver of a full block. On the first realisation, the steps with
/// saved fields write files for ParaView if the case requests them, and the
/// most heavily loaded of these steps records a stress section.
///
/// @param surface  the surface of the method; must outlive the solver
/// @param resources  of the ranks that solve the block: all calls are
/// collective
/// @throws std::domain_error, input::InputError  the mesh cannot be generated
///                                               or is rejected; the message
///                                               gives the reason
std::unique_ptr<StepSolver> make_full_block_solver(
    const cases::Case& contact_case, const cases::MethodSpec& method,
    const SurfaceOfCase& surface, int realization, const Resources& resources);

} // namespace asperity::methods
