#pragma once

// The levels of cells of the extension of a residual over the contact boundary.

#include "base/ranks/shared_rows.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace asperity::contact {

/// The cells of one level of BoundaryExtension. Ranks share the rows of fine
/// levels; from the first level on whose rows cannot be shared any more, each
/// rank stores all.
struct ExtensionLevel {
  ExtensionLevel(const SharedRows& own_, const SharedRows& stored_,
                 float variance_);

  SharedRows own;    ///< rows that this rank computes from the finer level
  SharedRows stored; ///< rows that it stores: its own, or all
  float variance;    ///< v_l
  std::vector<float> shares; ///< k_l
  std::vector<float> values; ///< with ghost rows

  /// The first of its own rows among those it stores.
  int offset() const { return own.first() - stored.first(); }

  float* row(int iy) {
    return values.data() + static_cast<std::size_t>(iy + 1) * stored.width();
  }

  const float* row(int iy) const {
    return values.data() + static_cast<std::size_t>(iy + 1) * stored.width();
  }

  float* shares_row(int iy) {
    return shares.data() + static_cast<std::size_t>(iy) * stored.width();
  }

  std::span<float> stored_values() { return {row(0), stored.size()}; }

  /// Gathers the rows of all ranks, where every rank stores all and computes
  /// its own. Collective.
  /// @param rows  the stored rows of `shares` or `values`
  void complete(std::span<float> rows) const;
};

/// The levels from cells of 2 by 2 nodes to the coarsest one.
/// @param rows  of the nodes
std::vector<ExtensionLevel> extension_levels(const SharedRows& rows);

} // namespace asperity::contact
