#pragma once

// The tangential stiffness of the contact of a load step, for [friction] of a
// case.

#include "run/contact_studies.hpp"

namespace asperity::run {

/// Adds to the row of a step with maps stick_stiffness_x and _y: the normal
/// stiffness of its contact (contact/solvers/punch_stiffness.hpp) over the
/// ratio kappa of the tangential compliance to the normal one, which follows
/// from the directions of the waves of the punch's pressure
/// (contact/operators/wave_directions.hpp). Both are omitted if the step has
/// not converged or the method has no partial slip; the note of the row says if
/// all nodes are in contact, which has no finite one.
void add_stick_stiffness(const StudiedMethod& studied,
                         methods::StepAnswer& answer);

} // namespace asperity::run
