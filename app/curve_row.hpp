#pragma once

// A solved step as a row of the curve: every elastic method is read by the
// same observables.

#include "app/step_solver.hpp"
#include "app/surfaces_of_case.hpp"
#include "contact/solver.hpp"
#include "results/area_estimate.hpp"

#include <span>

namespace asperity::app {

/// What the observables need to know of the operator behind a solution.
struct Observation {
  std::span<const double> nodal_weights; ///< contact::SurfaceOperator's
  double local_compliance = 0.0; ///< 1/k [m/Pa] of a penalty that stays, 0 for
                                 ///< a hard wall
  results::AreaCoefficients area_coefficients; ///< of the operator
  double contact_modulus = 0.0; ///< E* that the rim of a contact feels [Pa]
};

/// The solution's maps are moved into the answer.
StepAnswer observe(contact::ContactSolution solution,
                   const Observation& observation,
                   const SurfaceOfCase& surface);

} // namespace asperity::app
