#pragma once

// This file says who computes a loop over the nodes of a field: the threads of
// this process and the ranks that share the rows. It divides the rows so that
// sums have the same bits on any number of ranks.

#include <cstddef>
#include <span>
#include <vector>

#include "ranks/shared_rows.hpp"

namespace asperity {

/// Number of nodes in one chunk, which one thread sums.
inline constexpr std::size_t chunk_nodes = std::size_t{1} << 13;

/// Largest number of groups of chunks. Each rank holds whole groups; their sums
/// are gathered and added in order.
inline constexpr std::size_t most_groups = 1024;

/// Rows that one rank holds together: the side of the largest cells of
/// BoundaryExtension whose rows are shared on any grid.
inline constexpr std::size_t rows_in_cell = 8;

/// Number of chunks in a group of a field of all ranks together.
inline std::size_t chunks_in_group(std::size_t all_nodes) {
  const std::size_t chunks = (all_nodes + chunk_nodes - 1) / chunk_nodes;
  return chunks <= most_groups ? 1 : (chunks + most_groups - 1) / most_groups;
}

/// Threads and ranks. A number of threads stands for a process that holds all
/// nodes.
struct Workers {
  int threads = 1;                  ///< of this process, >= 1
  const SharedRows* rows = nullptr; ///< null if this process holds all nodes

  Workers(int threads_, const SharedRows* rows_ = nullptr)
      : threads(threads_), rows(rows_) {}

  /// Number of nodes on all ranks, of which this process holds `own`.
  std::size_t all_nodes(std::size_t own) const {
    return rows != nullptr ? rows->grid().size() : own;
  }
};

/// Bounds of the rows of each rank, see SharedRows, so that every rank holds
/// whole groups of chunks and rows_in_cell rows or multiples of them. If
/// possible, this also holds on grids of every second node.
/// @throws std::domain_error  n_ranks exceeds most_ranks(grid)
std::vector<int> row_bounds(const Grid& grid, int n_ranks);

/// Largest number of ranks that can share the rows of a grid, >= 1. It is small
/// if points_x contains large odd factors: shares begin at nodes that are
/// multiples of points_x and of chunk_nodes.
int most_ranks(const Grid& grid);

/// Whether bounds are of this kind on this grid.
bool holds_whole_groups(const Grid& grid, std::span<const int> bounds);

/// Gathers the sums of the groups of all ranks. Collective.
/// @param own  sums of the groups of this rank, each of `bytes` bytes
std::vector<std::byte> gathered_sums(const SharedRows& rows,
                                     std::span<const std::byte> own,
                                     std::size_t bytes);

/// Sum of a number over all ranks, itself if there are none. Collective.
std::size_t total_count(const Workers& workers, std::size_t own);

} // namespace asperity
