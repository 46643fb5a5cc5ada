#pragma once

// The last resort of the contact solver: the set of nodes in contact is found
// by exact solutions for fixed sets. For few nodes, where an iteration has
// stalled.

#include "contact/solvers/solver.hpp"

#include <span>

namespace asperity::contact {

/// The largest matrix that active_set() factors, in nodes: 34 MB. Every grid
/// of 64^2 nodes is within it, whatever is in contact.
inline constexpr std::size_t most_active_nodes = 2048;

/// The same problem as solve_contact by an active set: block principal
/// pivoting. One iteration: with n of N nodes free, the pressure that balances
/// them is found, of whatever sign, by a dense factor (ActiveSystem); then the
/// nodes that are pulled are fixed and those that overlap are freed. All of
/// them change sides as long as they become fewer within ten iterations, else
/// the last one only, which always ends for a positive compliance.
///
/// @param initial_pressure  as of solve_contact; the closer the fewer steps
/// @return  as solve_contact; not converged, and says why, where n and
///          N - n pass most_active_nodes, or after 200 iterations
///          or problem.max_iterations
/// @throws std::domain_error  see solve_contact
/// @par Accuracy  problem.gap_tolerance or, if that is larger, the rounding of
///      a gap: 64 eps (max |h| + |u| + p_max (C_max + c)), C_max that of the
///      longest wave. The note says where that was the case.
/// @par Cost  m^3 / 6 multiplications an iteration and m^2 numbers, m the
///      smaller of n and N - n. Where the block is not the same at every node,
///      as of second order, one application of C and a field of numbers more
///      for each node that is ever among the m. From a stalled iteration some
///      ten iterations.
/// @see  L. F. Portugal, J. J. Judice, L. N. Vicente, Math. Comput. 63, 625
///       (1994), without a prescribed load.
ContactSolution active_set(SurfaceOperator& elasticity,
                           const ContactProblem& problem,
                           const LoadTarget& target,
                           std::span<const double> initial_pressure = {});

} // namespace asperity::contact
