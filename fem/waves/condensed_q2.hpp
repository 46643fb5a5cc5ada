#pragma once

// The surface compliance of a laterally uniform Q2 block, identical to that of
// the finite-element discretisation, computed for one lateral wavevector at a
// time.

#include "fem/waves/elastic_layers.hpp"

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace asperity::fem {

/// The four node classes of a Q2 surface, by the parity (a, b) of the node's
/// place on the grid, with index a + 2 b: vertex, x-edge, y-edge, face centre.
constexpr std::size_t node_classes = 4;

/// A symmetric 4x4 block over node classes, row-major, with all entries stored.
using NodeClassBlock = std::array<double, node_classes * node_classes>;

/// Compliance blocks G(q) [m/Pa] of a Q2 block: pressures p_k exp(i q.x) at the
/// nodes of class k, where x is the actual place of the node, cause
/// displacements
///
///     u_k = sum_k' G_kk'(q) w_k' p_k',                                 (Q2.1)
///
/// where w are the relative nodal areas. Each node class has a single phase
/// because q lies in the Brillouin zone of the cells; wavevectors beyond it are
/// combinations of classes.
struct Q2Compliance {
  Grid grid; ///< all nodes; one cell spans two node spacings
  /// Blocks of the cell wavenumbers (jx, |jy|), each from 0 to cells/2, jx
  /// fastest; G is even in both.
  std::vector<NodeClassBlock> blocks;
  std::vector<double> class_weights; ///< w_k, mean 1

  int columns() const { return grid.points_x / 4 + 1; }

  int rows() const { return grid.points_y / 4 + 1; }
};

/// Computes the compliance as in (Q1.1), but with 12x12 blocks for the node
/// planes on cell faces and those at mid-height of each layer, which have four
/// node classes with three components each:
///
///     T_l = S_bb - R^T [ S_mm S_mt ; S_tm S_tt + T_(l+1) ]^-1 R,       (Q2.2)
///     R = [ S_mb ; S_tb ],   S(q) of layer l on its planes b, m, t,
///
/// computed by (Q2.4) and (Q2.5) for four wavevectors at a time.
///
/// At q = 0 a far boundary that is free to move is held by a spring on the
/// uniform mode of all classes; loads with zero mean do not stretch it.
///
/// @param grid     grid of the nodes of the contact surface: even, at least 4
///                 per side
/// @param threads  the result is bitwise independent of it
/// @throws std::domain_error  the grid or the block is outside its range
/// @par Accuracy
///         Roundoff: as for Q1, it affects the longest waves and the uniform
///         mode. A layer with the thickness of m cell widths causes a relative
///         error of m^2 eps in them, some 1e-11 at 512^2 with a grading ratio
///         of 1.2 and a depth of one period.
///         Discretisation: third order or better in the node spacing for waves
///         longer than a cell.
Q2Compliance condensed_compliance_q2(const Grid& grid,
                                     const LayeredBlock& block,
                                     int threads = 1);

/// Computes the blocks of a column: jx, and jy = 0..n-1, where n is the length
/// of the answer. Threads call it at the same time.
using Q2Column = std::function<void(int jx, std::span<NodeClassBlock> of_jy)>;

/// The blocks of condensed_compliance_q2(), with the same bits, by columns.
/// @throws std::domain_error  as condensed_compliance_q2()
Q2Column condensed_column_q2(const Grid& grid, const LayeredBlock& block);

} // namespace asperity::fem
