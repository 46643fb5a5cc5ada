#pragma once

// What the contact of a load step consists of and conducts, for [spots] and
// [conductance] of a case.

#include "cases/types/case.hpp"
#include "methods/methods.hpp"

#include <vector>

namespace asperity::run {

/// Whether a study of a case reads the maps of every load step.
bool needs_all_maps(const cases::Case& contact_case);

/// A method on a surface, of which a case asks for studies.
struct StudiedMethod {
  const cases::Case& contact_case;
  const cases::MethodSpec& method;
  const methods::SurfaceOfCase& surface;
  methods::MethodFactory& solvers; ///< for the operator of the method
  int threads = 1;
};

/// Adds to the row of a step with maps the numbers of its clusters
/// (results/observables/clusters.hpp) and what its contact conducts
/// (contact/solvers/punch_stiffness.hpp). The conductance is that
/// between two half-spaces, except that of the spots of a full block that has
/// found it on its mesh (methods::conducts_in_block); the normal stiffness is
/// that of the operator of a surface method without adhesion. Both are omitted
/// if the step has not converged; the note of the row says what cannot be
/// determined.
void add_contact_studies(const StudiedMethod& studied,
                         methods::StepAnswer& answer);

/// Sets the conductances of heat and current of a row by its relative
/// conductances and the conductivities, which are the harmonic means
/// 2 k_1 k_2/(k_1 + k_2) and 2/(rho_1 + rho_2).
void set_conductances(const cases::ConductanceStudy& study,
                      results::CurvePoint& row);

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
