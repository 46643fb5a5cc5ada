#pragma once

// The atomistic block as a method of a run: builds its two lattices on the
// surface of the case and converts its load steps to rows of the common curve.

#include "md/contact/atomic_contact.hpp"
#include "run/methods/step_solver.hpp"
#include "run/methods/surfaces_of_case.hpp"

#include <filesystem>
#include <memory>

namespace asperity::methods {

MethodDescription describe(const mechanics::MdSettings& settings);

/// The input of an atomistic method besides its settings.
struct AtomisticInput {
  const cases::Case& contact_case;
  const cases::MethodSpec& method;
  const SurfaceOfCase& surface; ///< must outlive the solver
  int realization = 0;
  int threads = 1;
  std::filesystem::path scratch; ///< for checkpoints, dumps and child processes
  md::Watch watch = {};          ///< called while a step is being solved
};

/// Creates the solver of an atomistic method.
///
/// @throws input::InputError   the surface is not square, settings contradict
///                             each other, or a required program is missing
/// @throws std::domain_error  the md module rejects the block
std::unique_ptr<StepSolver> make_atomic_solver(const AtomisticInput& atomistic);

} // namespace asperity::methods
