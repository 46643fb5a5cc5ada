#pragma once

// deal.II's stiffness matrix of one box-shaped cell, with its unknowns ordered
// by place instead of by deal.II's numbering.

#include "fem/waves/elastic_layers.hpp"

#include <cstddef>
#include <vector>

namespace asperity::fem {

/// Stiffness matrix K of one cell dx * dy * thickness with FE_Q(degree) and
/// QGauss(degree + 1):
///
///     K_rs = int_cell [ lambda div(phi_r) div(phi_s)
///                       + 2 mu eps(phi_r) : eps(phi_s) ] dV        [N/m]
///
/// The row of component c (0..2) of the node at grid of boxes place (a, b, k),
/// each 0..degree, where k = 0 is the side of the contact surface, is
/// ((k * (degree+1) + b) * (degree+1) + a) * 3 + c.
struct CellStiffness {
  int degree = 1;
  std::vector<double> entries; ///< row-major, size() * size() [N/m]

  std::size_t nodes_per_side() const {
    return static_cast<std::size_t>(degree) + 1;
  }

  std::size_t size() const {
    return 3 * nodes_per_side() * nodes_per_side() * nodes_per_side();
  }

  double at(std::size_t row, std::size_t column) const {
    return entries[row * size() + column];
  }

  /// The row of a component of a node.
  std::size_t row(std::size_t a, std::size_t b, std::size_t k,
                  std::size_t component) const {
    return ((k * nodes_per_side() + b) * nodes_per_side() + a) * 3 + component;
  }
};

/// @param degree  1 or 2
/// @param dx,dy   lateral side lengths of the cell [m] > 0
CellStiffness cell_stiffness(int degree, double dx, double dy,
                             const ElasticLayer& layer);

/// Nodal areas on a cell face relative to their mean, from the row sums of
/// deal.II's mass matrix of the face. The index is a + 2 b, where (a, b) is the
/// parity of the grid of boxes place; the values are four ones for degree 1 and
/// (1, 2, 2, 4) * 4/9 for degree 2.
std::vector<double> relative_nodal_areas(int degree);

} // namespace asperity::fem
