#pragma once

// The contact of an elastic surface and a rigid counter-surface that attract
// each other: local minima of the energy over the gap.

#include "contact/solvers/contact_problem.hpp"
#include "mechanics/contact_law.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace asperity::contact {

struct AdhesiveProblem {
  std::span<const double> heights; ///< h [m], elasticity.n_nodes() values
  mechanics::ContactInterface law; ///< of SurfaceSolver::adhesive
  double gap_tolerance = 0.0;      ///< of the rms correction of the gap [m] > 0
  int max_iterations = 2000;
  /// k_c [Pa/m] > 0, see below: adhesive_scale() of the heights.
  double preconditioner_stiffness = 0.0;
  /// Of the load that the law does not carry, over <|p|> [1] > 0.
  double load_tolerance = 1e-8;
  /// 1 at nodes with a counter-surface, 0 at others; empty: all have one.
  std::span<const std::uint8_t> opposed = {};
};

/// k_c = <h, K h> / <h, h> [Pa/m], the stiffness of the waves that have most of
/// the heights, but at least 1e-4 of that of short waves; that of short waves
/// divided by 16 for a flat surface. Costs one application of K.
double adhesive_scale(SurfaceOperator& elasticity,
                      std::span<const double> heights);

/// The note of a tensile load that parted the faces.
std::string detached_note(double nominal_pressure);

/// Find the gap g >= 0 that is a local minimum of the energy per nominal area
///
///     U(g) = <v, K v>/2 + <W(g)> + p_0 <g>,   v = g + h - <g + h>
///
/// with K = C^-1, or of the first two terms under the condition that <g> is the
/// prescribed mean gap, whose multiplier is p_0, or with the energy of a
/// spring, k (<g> - d)^2/2, instead of p_0 <g>; p_0 = k (<g> - d) then. The
/// pressure is p = K v + p_0:
/// the law's -W'(g) where the gap is open, and at least that where the wall
/// carries a load. Loads by pressure may be tensile, p_0 <= 0. A law without a
/// wall has no bound on the gap, and all its nodes are free; a node goes at
/// most 0.4 of its way to the core of the law in a step.
///
/// With w > 0 there may be several minima. The solver goes downhill from
/// `start`, and reports a neighbouring one. Each iteration is one of L-BFGS
/// with four pairs on the free nodes, those with an open gap or a negative
/// residual r = K v + W' + p_0; its initial matrix M, about (K + k)^-1, is
/// that of AdhesiveState::precondition(). The step is clipped at the wall,
/// shortened until the exact energy has fallen (Armijo), and thus no iteration
/// raises the energy. It has converged if the
/// rms of M r on the free nodes is at most gap_tolerance, and the load that
/// they carry without the law, AdhesiveState::missing_load(), at most
/// load_tolerance: where the elastic surface is much stiffer than the law, the
/// first alone leaves an error of the order of the load. LOBPCG then looks for
/// the smallest eigenvalue of the Hessian K + W'' of the free nodes; where it
/// is negative (a saddle), the solver goes along the eigenvector and on from
/// there.
///
/// A tensile load that the law cannot carry at the smallest gap of the surface
/// ends with ContactSolution::is_detached.
///
/// @param elasticity  must have_inverse() and nodes of equal areas
/// @param start       gap [m], n_nodes() values that the law admits; under gap
///                    control it is shifted to the prescribed mean where the
///                    gap is open
/// @throws std::domain_error  a size or a number is outside its range, a mean
///         gap without a spring is <= 0, or the operator has no inverse
/// @see  J. Nocedal, S. J. Wright, Numerical Optimization (2006), ch. 7;
///       A. V. Knyazev, SIAM J. Sci. Comput. 23, 517 (2001);
///       docs/numerics/adhesion.md
ContactSolution solve_adhesive(SurfaceOperator& elasticity,
                               const AdhesiveProblem& problem,
                               const mechanics::LoadTarget& target,
                               std::vector<double> start);

} // namespace asperity::contact
