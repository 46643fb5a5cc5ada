#pragma once

// The last resort of the contact solver: the set of nodes in contact is found
// by exact Newton steps. For few nodes, where an iteration has stalled.

#include "contact/solver.hpp"

#include <span>

namespace asperity::contact {

/// The largest matrix that active_set() factors, in nodes: 34 MB. Every grid
/// of 64^2 nodes is within it, whatever is in contact.
inline constexpr std::size_t most_active_nodes = 2048;

/// The same problem as solve_contact by an active set of quadratic
/// programming. One iteration: with n of N nodes in contact or overlapping, the
/// step d to the minimum of
///
///     E(p) = 1/2 <p, (C + c) p> - <p, h>  at the prescribed load (or gap)
///
/// on these nodes is taken, by a dense factor (ActiveSystem). Pressures below 0
/// are cut if that lowers E by as much as the part of the step before the first
/// of them falls to 0 does; if not for any half of the step, that part is the
/// step, and nodes that would enter with p < 0 stay out. E falls in every
/// iteration, so no set comes back and the method ends.
///
/// @param initial_pressure  as of solve_contact; the closer the fewer steps
/// @return  as solve_contact; not converged, and says why, where n and
///          N - n pass most_active_nodes, or after problem.max_iterations
/// @throws std::domain_error  see solve_contact
/// @par Accuracy  problem.gap_tolerance or, if that is larger, the rounding of
///      a gap: 64 eps (max |h| + |u| + p_max (C_max + c)), C_max that of the
///      longest wave. The note says where that was the case.
/// @par Cost  m^3 / 6 multiplications an iteration and m^2 numbers, m the
///      smaller of n and N - n. Where the block is not the same at every node,
///      as of second order, one application of C and a field of numbers more
///      for each node that is ever among the m. From a stalled iteration some
///      ten iterations.
/// @see  C. L. Lawson, R. J. Hanson, Solving Least Squares Problems (1974),
///       chapter 23, for one node at a time and no load.
ContactSolution active_set(SurfaceOperator& elasticity,
                           const ContactProblem& problem,
                           const LoadTarget& target,
                           std::span<const double> initial_pressure = {});

} // namespace asperity::contact
