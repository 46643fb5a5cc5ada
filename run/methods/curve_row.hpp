#pragma once

// Evaluates a solved load step as a row of the curve. All elastic methods use
// the same observables.

#include "contact/solvers/contact_problem.hpp"
#include "mechanics/contact_law.hpp"
#include "results/observables/area_estimate.hpp"
#include "results/observables/row_observer.hpp"
#include "run/methods/step_solver.hpp"
#include "run/methods/surfaces_of_case.hpp"

#include <limits>
#include <optional>
#include <span>

namespace asperity::methods {

/// The properties of the operator behind a solution that the observables need.
struct Observation {
  std::span<const double> nodal_weights; ///< as in contact::SurfaceOperator
  double local_compliance = 0.0; ///< 1/k [m/Pa] for a penalty law, 0 for hard
                                 ///< or augmented contact
  results::AreaCoefficients area_coefficients; ///< of the operator
  double contact_modulus = 0.0;  ///< effective E* at the contact boundary [Pa]
  bool resolves_boundary = true; ///< false: the caller sets the corrected area
  results::Border border = results::Border::periodic;
  /// How contact is decided in the fields.
  mechanics::ContactCriterion criterion = {};
  /// Whether the surface has a middle and thus the load a lever: a single
  /// shape.
  bool has_middle = false;
  int threads = 1;
  /// The contact law, if it has adhesion, and its grid_number().
  std::optional<mechanics::ContactInterface> adhesion = std::nullopt;
  double grid_number = 0.0;
  double hardness = std::numeric_limits<double>::infinity(); ///< H [Pa]
};

/// Evaluates the two contact areas that follow from fits to the pressure
/// distribution of the theory. Elastic and atomistic methods share this
/// function.
///
/// @param weights  relative weights of the nodes; empty if all are equal
void observe_pressure_fits(results::RowObserver& observe,
                           std::span<const double> pressure,
                           std::span<const double> weights = {},
                           int threads = 1);

/// Evaluates the areas of repulsion and of tension and the attractive load of a
/// row with adhesion. Elastic and atomistic methods share this function.
///
/// @param pressure  of the nodes, or of the atoms of a layer [Pa]
/// @param weights   relative weights of the nodes; empty if all are equal
void observe_tension(results::CurvePoint& row, std::span<const double> pressure,
                     const mechanics::ContactNodes& nodes,
                     const mechanics::ContactInterface& law,
                     std::span<const double> weights = {}, int threads = 1);

/// Evaluates a solution. Its fields are moved into the answer. An observable
/// that cannot be evaluated does not end the run: it is NaN, and the note of
/// the row gives the reason.
StepAnswer observe(contact::ContactSolution solution,
                   const Observation& observation,
                   const SurfaceOfCase& surface);

/// Marks a step as not converged if its mean gap, nominal pressure or fields
/// are not finite, whatever the method reports, and discards fields that are
/// not finite.
void distrust_non_finite(StepAnswer& answer);

} // namespace asperity::methods
