#pragma once

// The block of atoms as a method of the run: its two lattices over the case's
// surface, and its steps as rows of the common curve.

#include "app/methods/step_solver.hpp"
#include "app/methods/surfaces_of_case.hpp"
#include "md/contact/atomic_contact.hpp"

#include <filesystem>
#include <memory>

namespace asperity::app {

MethodDescription describe(const cases::MdSettings& settings);

/// What an atomic method needs besides its settings.
struct AtomicScene {
  const cases::Case& rough_case;
  const cases::MethodSpec& method;
  const SurfaceOfCase& surface; ///< outlives the solver
  int realization = 0;
  int threads = 1;
  std::filesystem::path scratch; ///< for checkpoints, dumps and child processes
  md::Watch watch = {};          ///< called while a step is at work
};

/// @throws cases::CaseError   a surface that is not square, settings that do
///                            not go together, a program that is missing
/// @throws std::domain_error  what the atoms' room refuses
std::unique_ptr<StepSolver> make_atomic_solver(const AtomicScene& scene);

} // namespace asperity::app
