#pragma once

// Solves a network with about half of its nodes.

#include "mechanics/flow/network.hpp"

namespace asperity::flow {

/// Eliminates nodes of which no two are neighbours (of a grid every other node,
/// as on a chessboard), solves for the potentials of the others, and finds
/// those of the eliminated ones from their neighbours. The elimination is
/// exact; the conductances of the reduced network are sums of positive numbers.
///
/// @param solve  solves the reduced network
NetworkSolution solved_by_elimination(const Network& network,
                                      const SolveNetwork& solve);

} // namespace asperity::flow
