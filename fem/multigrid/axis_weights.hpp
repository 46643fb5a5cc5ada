#pragma once

// Interpolation between the nodes of a coarse and a fine grid of boxes, one
// axis at a time.

#include "fem/multigrid/sparse_rows.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// One axis: the places of the cells' sides, increasing from 0.
struct BoxGridAxis {
  int degree = 1;
  bool is_periodic = false;
  std::vector<double> sides;

  std::size_t cells() const { return sides.size() - 1; }

  /// Number of nodes without the image of the first.
  std::size_t nodes() const {
    return static_cast<std::size_t>(degree) * cells() + (is_periodic ? 0 : 1);
  }

  double node(std::size_t number) const;

  /// The cell that contains a place; of two the first.
  std::size_t cell_at(double place) const;
};

/// The values of the coarse shape functions at the fine nodes: a row per fine
/// node, a column per coarse node. The grids of boxes need not be nested.
SparseRows interpolation(const BoxGridAxis& coarse, const BoxGridAxis& fine);

/// The fine node nearest to each coarse node.
std::vector<std::size_t> nearest_fine(const BoxGridAxis& coarse,
                                      const BoxGridAxis& fine);

/// The part of each coarse cell that each fine cell covers: a row per coarse
/// cell, with sum 1.
SparseRows coverage(const BoxGridAxis& coarse, const BoxGridAxis& fine);

} // namespace asperity::fem
