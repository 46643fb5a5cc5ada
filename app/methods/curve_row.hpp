#pragma once

// A solved step as a row of the curve: every elastic method is read by the
// same observables.

#include "app/methods/step_solver.hpp"
#include "app/methods/surfaces_of_case.hpp"
#include "contact/solvers/solver.hpp"
#include "results/observables/area_estimate.hpp"
#include "results/observables/row_observer.hpp"

#include <span>

namespace asperity::app {

/// What the observables need to know of the operator behind a solution.
struct Observation {
  std::span<const double> nodal_weights; ///< contact::SurfaceOperator's
  double local_compliance = 0.0; ///< 1/k [m/Pa] of a penalty that stays, 0 for
                                 ///< a hard wall
  results::AreaCoefficients area_coefficients; ///< of the operator
  double contact_modulus = 0.0; ///< E* that the rim of a contact feels [Pa]
  bool has_rim = true; ///< false: the corrected area is left to the caller
};

/// Both areas of the theory's pressure distribution, of elastic methods and of
/// atoms alike.
/// @param weights  of the nodes, relative; empty if all are equal
void observe_pressure_fits(results::RowObserver& observe,
                           std::span<const double> pressure,
                           std::span<const double> weights = {});

/// The solution's maps are moved into the answer. No map ends the run: an
/// observable that it does not have is NaN, and the row's note says why.
StepAnswer observe(contact::ContactSolution solution,
                   const Observation& observation,
                   const SurfaceOfCase& surface);

/// A step whose mean gap, nominal pressure or maps are not finite did not
/// converge, whatever the method says, and its maps are not kept.
void distrust_non_finite(StepAnswer& answer);

} // namespace asperity::app
