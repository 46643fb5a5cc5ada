#pragma once

// Elastic face against a rigid obstacle: the complementarity problem, its
// answer, and the preconditioned solver that every elastic method uses.

#include "contact/operators/surface_operator.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::contact {

/// Find the pressure p and the rigid distance u with
///
///     gap = u + (C p)(x) - h(x)
///     p >= 0,  gap + c p >= 0,  p (gap + c p) = 0     at every node
///
/// c = 1/k is the compliance of a linear penalty (p = k times penetration);
/// c = 0 is the hard wall.
struct ContactProblem {
  std::span<const double> heights; ///< h [m], grid.size() values
  double local_compliance = 0.0;   ///< c = 1/k [m/Pa] >= 0
  /// Largest gap in contact and largest overlap outside it that is accepted
  /// [m] > 0. The work p |gap| left over is then below p_0 times this.
  double gap_tolerance = 0.0;
  int max_iterations = 2000;
};

/// What is prescribed: the mean of p [Pa] > 0, or of the gap [m].
struct LoadTarget {
  enum class Kind { nominal_pressure, mean_gap } kind = Kind::nominal_pressure;
  double amount = 0.0;
};

struct ContactSolution {
  std::vector<double> pressure;     ///< p [Pa] >= 0
  std::vector<double> gap;          ///< [m]; -c p where in contact
  std::vector<double> displacement; ///< C p [m], mean 0
  double nominal_pressure = 0.0;    ///< mean of p [Pa]
  double mean_gap = 0.0;            ///< mean of the gap [m]
  double gap_error = 0.0; ///< largest violation, see gap_tolerance [m]
  int iterations = 0;     ///< of the solver on this grid
  int transforms = 0;     ///< applications of C or its inverse on this grid
  bool converged = false;
  std::string note; ///< what went otherwise than usual; empty if nothing
};

/// Projected preconditioned conjugate gradients on the free nodes, which are
/// those in contact and those that overlap. One iteration: residual gap r on
/// the free nodes, continued over the rim (RimExtension), direction from
/// (C + c)^-1 masked to them, folded back the same way, Polak-Ribiere
/// conjugation, exact step, pressures cut at 0. Nodes that overlap enter with
/// what the direction gives them, so no scale for their entry is guessed.
///
/// A residual that has not halved within 150 iterations sends the problem to
/// active_set(), and if that has too many nodes to polonsky_keer(), from where
/// the iteration stood; the note says so. A slab thinner than length/20 with a
/// free back bends like a plate and may need it.
///
/// @param elasticity       C; its scratch is used
/// @param initial_pressure start [Pa], grid.size() values >= 0 with a positive
///                         one, or empty for a uniform pressure
/// @throws std::domain_error  a size or a number is outside its range; a mean
///         gap is asked that a hard wall does not allow (<= 0)
/// @par Accuracy  The discrete problem to gap_tolerance; mean pressure (or
///            gap) to rounding.
/// @see  I. A. Polonsky, L. M. Keer, Wear 231, 206 (1999) for the plain
///       method; preconditioner and free set are ours (docs/solver.md).
ContactSolution solve_contact(SurfaceOperator& elasticity,
                              const ContactProblem& problem,
                              const LoadTarget& target,
                              std::span<const double> initial_pressure = {});

/// The judge: conjugate gradients of Polonsky and Keer, no preconditioner.
/// Same arguments and answer. Slow, and it always ends.
ContactSolution polonsky_keer(SurfaceOperator& elasticity,
                              const ContactProblem& problem,
                              const LoadTarget& target,
                              std::span<const double> initial_pressure = {});

} // namespace asperity::contact
