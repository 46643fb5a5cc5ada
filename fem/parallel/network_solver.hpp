#pragma once

// Solves networks of conductances by conjugate gradients with hypre's algebraic
// multigrid.

#include "mechanics/flow/network.hpp"

namespace asperity::fem {

/// Solves as flow::SolveNetwork says, on this process alone. Calls from several
/// threads wait for each other, because MPI serves one of them at a time. MPI
/// must run.
/// @see  V. E. Henson, U. M. Yang, Appl. Numer. Math. 41, 155 (2002)
flow::NetworkSolution solved_network(const flow::Network& network);

} // namespace asperity::fem
