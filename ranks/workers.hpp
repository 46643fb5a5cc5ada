#pragma once

// Who computes a loop over the nodes of a field: the threads of this process
// and the ranks that share the rows. It divides the rows so that sums have the
// same bits on any number of ranks.

#include "ranks/node_chunks.hpp"
#include "ranks/shared_rows.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity {

/// Threads and ranks. A number of threads stands for a process that holds all
/// nodes, and whose sums need not be those of ranks.
struct Workers {
  int threads = 1;                  ///< of this process, >= 1
  const SharedRows* rows = nullptr; ///< null if this process holds all nodes
  NodeChunks chunks;

  Workers(int threads_) : threads(threads_) {}

  /// @param rows_  must outlive this object
  Workers(int threads_, const SharedRows& rows_)
      : Workers(threads_, rows_.grid(), &rows_) {}

  /// @param rows_  of the grid; null for a process that holds all nodes
  Workers(int threads_, const Grid& grid, const SharedRows* rows_ = nullptr)
      : threads(threads_), rows(rows_), chunks(grid) {}

  /// Number of nodes on all ranks, of which this process holds `own`.
  std::size_t all_nodes(std::size_t own) const {
    return rows != nullptr ? rows->grid().size() : own;
  }
};

/// Bounds of the rows of each rank, see SharedRows, so that every rank holds
/// whole units and groups of chunks (NodeChunks). If possible, this also holds
/// on grids of every second node.
/// @throws std::domain_error  n_ranks exceeds most_ranks(grid)
std::vector<int> row_bounds(const Grid& grid, int n_ranks);

/// Largest number of ranks that can share the rows of a grid, >= 1.
int most_ranks(const Grid& grid);

/// Whether bounds are of this kind on this grid.
bool holds_whole_groups(const Grid& grid, std::span<const int> bounds);

/// The rows of a grid of every second node: half of those of each rank if these
/// then hold whole groups, otherwise all rows on each rank.
/// @param coarse  half the points of the grid of `rows`, which are even
SharedRows coarse_rows(const SharedRows& rows, const Grid& coarse);

/// Gathers the sums of the groups of all ranks. Collective.
/// @param own  sums of the groups of this rank, each of `bytes` bytes
std::vector<std::byte> gathered_sums(const SharedRows& rows,
                                     std::span<const std::byte> own,
                                     std::size_t bytes);

/// Sum of a number over all ranks, itself if there are none. Collective.
std::size_t total_count(const Workers& workers, std::size_t own);

} // namespace asperity
