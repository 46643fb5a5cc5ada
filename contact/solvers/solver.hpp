#pragma once

// The entry to the solution of a contact problem: the preconditioned solver
// that all elastic models use.

#include "contact/solvers/contact_problem.hpp"

#include <functional>
#include <span>
#include <vector>

namespace asperity::contact {

/// Projected preconditioned conjugate gradients on the active nodes, which are
/// those in contact and those that overlap. Each iteration takes the residual
/// gap r on the active nodes, extends it across the contact boundary
/// (BoundaryExtension), applies (C + c)^-1, restricts the result to the active
/// nodes by the transpose of the extension, conjugates it (Polak-Ribiere),
/// makes an exact line search and sets negative pressures to 0. Overlapping
/// nodes enter with the value of the search direction, so no scale for their
/// pressure has to be guessed.
///
/// If the residual has not halved within 150 iterations, or if there is no
/// descent direction, the problem is passed with its current pressure to
/// active_set(), and to polonsky_keer() if that does not converge, for example
/// because there are too many nodes; the note reports this. A slab thinner than
/// length/20 with a traction-free far boundary bends like a plate and may need
/// it.
///
/// @param elasticity       C; its scratch is used
/// @param initial_pressure initial guess [Pa], n_nodes() values >= 0 with at
///                         least one positive, or empty for a uniform pressure
/// @throws std::domain_error  a size or a number is outside its range; the
///         prescribed mean gap is impossible in hard contact (<= 0) or the
///         operator has free boundaries; the nominal pressure is above H
/// @par Accuracy  The discrete problem is solved to gap_tolerance; the mean
///            pressure (or gap) is exact to roundoff.
/// @see  I. A. Polonsky, L. M. Keer, Wear 231, 206 (1999) for the
///       unpreconditioned method; the preconditioner and the active set are
///       described in docs/numerics/solver.md.
ContactSolution solve_contact(SurfaceOperator& elasticity,
                              const ContactProblem& problem,
                              const mechanics::LoadTarget& target,
                              std::span<const double> initial_pressure = {});

/// Another initial guess, for the case that the first one is a poor one.
struct OtherGuess {
  double above = 0.0; ///< error of the first guess from which it is made [m]
  std::function<std::vector<double>()> make = {}; ///< empty: there is none
};

/// The same, with the memory of the initial guess, which is used for the
/// pressure.
ContactSolution solve_contact_from(std::vector<double> initial_pressure,
                                   SurfaceOperator& elasticity,
                                   const ContactProblem& problem,
                                   const mechanics::LoadTarget& target,
                                   const OtherGuess& other = {});

} // namespace asperity::contact
