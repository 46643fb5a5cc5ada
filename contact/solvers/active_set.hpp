#pragma once

// An active-set method for the contact problem, used when the iterative solver
// stagnates: it finds the set of nodes in contact by exact solutions for fixed
// sets. It is limited to problems with few nodes.

#include "contact/solvers/contact_problem.hpp"

#include <span>

namespace asperity::contact {

/// Solves the problem of solve_contact by an active-set method, block principal
/// pivoting. With n of N nodes active, each iteration finds the pressure, of
/// either sign, that satisfies the contact condition at these nodes, by a dense
/// factorisation (ActiveSystem). Active nodes with a tensile pressure then
/// become inactive, and inactive nodes that overlap become active. All of these
/// nodes are exchanged as long as their number reaches a new minimum at least
/// once in ten iterations, otherwise only the last one, which guarantees
/// termination for a positive definite compliance.
///
/// @param initial_pressure  as for solve_contact; a good estimate saves
///                          iterations
/// @return  as solve_contact; not converged, with the reason in the note, if
///          both n and N - n exceed most_active_nodes, if the stored fields
///          (see Cost) would exceed 128 MB, or after 200 iterations or
///          problem.max_iterations
/// @throws std::domain_error  see solve_contact
/// @par Accuracy  problem.gap_tolerance or, if that is larger, the roundoff
///      error of a gap: 64 eps (max |h| + |u| + p_max (C_max + c)), C_max that
///      of the longest wavelength. The note says where that was the case.
/// @par Cost  m^3 / 6 multiplications per iteration and storage for m^2
///            numbers, m the smaller of n and N - n. A block that is not
///            laterally homogeneous on the node grid, such as one with elements
///            of second order, also needs one application of C and one stored
///            field for each node that is ever among the m. A stagnated
///            iteration takes about ten iterations to complete. If ranks share
///            the rows and the problem is within the limits, each rank holds
///            whole fields and solves it, with the bits of one process.
/// @see  L. F. Portugal, J. J. Judice, L. N. Vicente, Math. Comput. 63, 625
///       (1994), without a prescribed load.
ContactSolution active_set(SurfaceOperator& elasticity,
                           const ContactProblem& problem,
                           const mechanics::LoadTarget& target,
                           std::span<const double> initial_pressure = {});

} // namespace asperity::contact
