#pragma once

// The last resort of the contact solver: the set of nodes in contact is found
// by exact Newton steps. For few nodes, where an iteration has stalled.

#include "contact/solver.hpp"

#include <span>

namespace asperity::contact {

/// The most nodes that active_set() takes in contact: their matrix then has
/// 32 MB, the columns it is made of 16 kB a grid node.
inline constexpr std::size_t most_active_nodes = 2000;

/// The same problem as solve_contact by an active set of quadratic
/// programming. One iteration: with n nodes in contact or overlapping, their
/// compliance C + c is factored densely and the step d to the minimum of
///
///     E(p) = 1/2 <p, (C + c) p> - <p, h>  at the prescribed load (or gap)
///
/// on these nodes is taken. Pressures below 0 are cut if that lowers E by as
/// much as the part of the step before the first of them falls to 0 does; if
/// not for any half of the step, that part is the step, and nodes that would
/// enter with p < 0 stay out. E falls in every iteration, so no set comes back
/// and the method ends.
///
/// @param initial_pressure  as of solve_contact; the closer the fewer steps
/// @return  as solve_contact; not converged, and says why, where n would pass
///          most_active_nodes, or after problem.max_iterations
/// @throws std::domain_error  see solve_contact
/// @par Accuracy  problem.gap_tolerance or, if that is larger, the rounding of
///      a gap: 64 eps (max |h| + |u| + p_max (C_max + c)), C_max that of the
///      longest wave. The note says where that was the case.
/// @par Cost  n^3 / 3 multiplications an iteration, n^2 numbers; one
///      application of C, and a field of numbers, for each node that is ever
///      in contact. From a stalled iteration some ten iterations.
/// @see  C. L. Lawson, R. J. Hanson, Solving Least Squares Problems (1974),
///       chapter 23, for one node at a time and no load.
ContactSolution active_set(SurfaceOperator& elasticity,
                           const ContactProblem& problem,
                           const LoadTarget& target,
                           std::span<const double> initial_pressure = {});

} // namespace asperity::contact
