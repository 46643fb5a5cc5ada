#pragma once

// Which methods the ranks of mpirun solve together.

#include "input/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::methods {

/// Smallest number of nodes whose rows the ranks share: below it, a step takes
/// less than a tenth of a second in one process.
inline constexpr std::size_t least_shared_nodes = std::size_t{512} * 512;

/// Returns whether the ranks share the rows of a method on this grid: it is a
/// periodic half-space or slab or a condensed block without adhesion, with at
/// least least_shared_nodes nodes, and the rows can be divided among so many
/// ranks.
bool is_shared_by_ranks(const cases::MethodSpec& method, const Grid& grid,
                        int n_ranks);

/// Why so many ranks cannot share the rows of a method of this kind and size,
/// as a part of a sentence; empty if they can, and for other methods.
std::string obstacle_to_sharing(const cases::MethodSpec& method,
                                const Grid& grid, int n_ranks);

/// Returns whether so many ranks solve one of the methods together: a full
/// block, or one whose rows they share.
/// @param grid  of the surface of the case
bool is_run_by_ranks(const cases::Case& contact_case,
                     const std::vector<cases::MethodSpec>& methods,
                     const Grid& grid, int n_ranks);

} // namespace asperity::methods
