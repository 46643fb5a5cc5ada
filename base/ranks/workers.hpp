#pragma once

// Who computes a loop over the nodes of a field: the threads of this process
// and the ranks that share the rows.

#include "base/ranks/shared_rows.hpp"

#include <cstddef>

namespace asperity {

/// Threads and ranks. A number of threads stands for a process that holds all
/// nodes.
struct Workers {
  int threads = 1;                  ///< of this process, >= 1
  const SharedRows* rows = nullptr; ///< null if this process holds all nodes

  /// @param rows_  must outlive this object
  Workers(int threads_, const SharedRows* rows_ = nullptr)
      : threads(threads_), rows(rows_) {}

  RankGroup* ranks() const { return rows != nullptr ? rows->ranks() : nullptr; }

  /// Number of nodes on all ranks, of which this process holds `own`.
  std::size_t all_nodes(std::size_t own) const {
    return rows != nullptr ? rows->grid().size() : own;
  }
};

/// Sum of a number over all ranks. Collective.
inline std::size_t total_count(const Workers& workers, std::size_t own) {
  return static_cast<std::size_t>(
      rank_sum(workers.ranks(), static_cast<double>(own)));
}

} // namespace asperity
