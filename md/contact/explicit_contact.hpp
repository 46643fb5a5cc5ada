#pragma once

// The engine with an explicit bulk: the multiscale block, solved by L-BFGS or
// molecular dynamics.

#include "md/contact/atomic_contact.hpp"

#include <memory>

namespace asperity::md {

/// Creates a block with request.settings.levels levels of
/// request.settings.layers layers of cells; settings.depth is not used. A
/// prescribed mean gap is imposed on the lowest layer, which is lowered in
/// steps that are short enough for the surface to deform.
///
/// With the minimizer `dynamics` and T = 0, the motion is damped until the
/// residual is within the tolerance or until `duration` has elapsed, which is
/// then reported. At T > 0, the pressure is the mean over the second half of
/// `duration`; gap, energies and inspection are evaluated at the mean
/// positions, except that the interface energy is the mean of its samples;
/// `note` states the fluctuations of the mean pressure and height; and the
/// residual is the relative deviation of the mean pressure from the load (0
/// under a prescribed height). Each load step uses its own random numbers. If a
/// scratch folder is given, a checkpoint such as "step-0003.motion" is written
/// there at regular intervals, from which the same step of the same block
/// resumes.
///
/// If settings.dump is set, all atoms are written to scratch / "step-0003.xyz".
///
/// @throws input::InputError   modes = "normal", or another engine or bulk
/// @throws std::domain_error  an argument of a component is out of range
std::unique_ptr<AtomicContact> make_explicit_contact(AtomRequest request);

} // namespace asperity::md
