#pragma once

// The surface compliance of a laterally uniform Q2 block, exactly that of the
// finite-element discretisation, one lateral wavevector at a time.

#include "fem/waves/elastic_layers.hpp"

#include <array>
#include <vector>

namespace asperity::fem {

/// The four kinds of nodes of a Q2 face, by parity (a, b) of the node's place
/// on the grid, index a + 2 b: corner, x-edge, y-edge, face centre.
constexpr std::size_t node_kinds = 4;

/// A symmetric 4x4 block over node kinds, row-major and full.
using KindBlock = std::array<double, node_kinds * node_kinds>;

/// Compliance blocks G(q) [m/Pa] of a Q2 block: pressures p_k exp(i q.x) at the
/// nodes of kind k (x their true places) give displacements
///
///     u_k = sum_k' G_kk'(q) w_k' p_k',                                 (Q2.1)
///
/// w the relative nodal areas. A node kind has one phase because q is taken in
/// the cells' Brillouin zone; wavevectors beyond it are mixtures of kinds.
struct Q2Compliance {
  Grid grid;                     ///< of all nodes: two steps are one cell
  std::vector<KindBlock> blocks; ///< cell wavenumbers (jx, |jy|), each from 0
                                 ///< to cells/2, jx fastest; G is even in both
  std::vector<double> kind_weights; ///< w_k, mean 1

  int columns() const { return grid.points_x / 4 + 1; }

  int rows() const { return grid.points_y / 4 + 1; }
};

/// As (Q1.1), with 12x12 blocks for the planes of nodes on cell faces and those
/// half way up each layer, four node kinds of three components each:
///
///     T_l = S_bb - R^T [ S_mm S_mt ; S_tm S_tt + T_(l+1) ]^-1 R,       (Q2.2)
///     R = [ S_mb ; S_tb ],   S(q) of layer l on its planes b, m, t,
///
/// computed by (Q2.4) and (Q2.5), four wavevectors at a time.
///
/// At q = 0 a top that is free to move is held by a spring on the uniform mode
/// of all kinds; loads without a mean do not stretch it.
///
/// @param grid     of the nodes of the contact face: even, at least 4 a side
/// @param threads  changes no bit of the answer
/// @throws std::domain_error  the grid or the block is outside its range
/// @par Accuracy
///         Rounding as in Q1, of the longest waves and the uniform mode: a
///         layer m cells thick loses m^2 eps of them, some 1e-11 at 512^2 with
///         layers growing by 1.2 to a depth of one length. Discretisation:
///         third order and better in the node spacing for waves longer than a
///         cell.
Q2Compliance condensed_compliance_q2(const Grid& grid,
                                     const LayeredBlock& block,
                                     int threads = 1);

} // namespace asperity::fem
