#pragma once

// Bulk explicit behind the room's front door: the multiscale block, by L-BFGS,
// FIRE or motion in time.

#include "md/contact/atomic_contact.hpp"

#include <memory>

namespace asperity::md {

/// The block has request.settings.levels levels of .layers layers of cells;
/// .depth is not used. Loads given as a mean gap are held at the lowest layer:
/// the first of them is come down to from above, in steps short enough for the
/// surface to give way.
///
/// Minimizer dynamics: at T = 0 damped motion until the residual is within
/// tolerance or `duration` is over, which is then said. At T > 0 pressure is
/// the mean over the second half of `duration`; gap, energies and inspection
/// are those of the mean positions, `note` says how much the mean pressure and
/// height fluctuate, and residual is how far the mean pressure is from the
/// load (0 where the height is held). Each load step has its own kicks. With
/// a scratch folder the motion is put aside there every 1000 steps,
/// "step-0003.motion", and the same step of the same block goes on from it.
///
/// settings.dump writes all atoms to scratch / "step-0003.xyz".
///
/// @throws cases::CaseError   modes = "normal", another engine or bulk
/// @throws std::domain_error  what a part refuses
std::unique_ptr<AtomicContact> make_explicit_contact(AtomRequest request);

} // namespace asperity::md
