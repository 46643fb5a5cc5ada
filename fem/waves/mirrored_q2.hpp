#pragma once

// The surface stiffness of a Q2 block at four wavevectors, with each layer
// split into its even and odd parts under reflection about its mid-plane.

#include "fem/waves/block_symbol.hpp"

namespace asperity::fem {

/// Computes T_0 of (Q2.2) from layers that are symmetric about their
/// mid-planes. Let P change the sign of u_z, let p denote the in-plane
/// components and v = u_z. The even part of the planes (p equal, v opposite)
/// couples to p of the mid-height nodes only, and the odd part to v only. After
/// elimination of these, each of the two planes of a layer has
///
///     F = S_tt   - X^T S_pp^-1 X - Y^T S_vv^-1 Y,                   (Q2.4)
///     H = S_tb P - X^T S_pp^-1 X + Y^T S_vv^-1 Y,
///     X = S_mt of the half-way p, Y of the half-way v,
///     T_l = P [ F - H (F + T_(l+1))^-1 H ] P,                       (Q2.5)
///
/// which are all symmetric 12x12 matrices. This form takes a quarter of the
/// time of (Q2.2) itself, whose matrices have twice the size.
class MirroredQ2 {
public:
  /// @param grid  grid of the nodes of the contact surface
  MirroredQ2(const Grid& grid, const LayeredBlock& block);

  /// Computes (T_0^-1)_zz over the node classes [m/N].
  /// @param theta_x, theta_y  q times the node spacing, one wavevector per lane
  /// @param spring            spring on the uniform mode of the free components
  ///                          of the far boundary [N/m]
  /// @param block             node_classes^2 packs, with all entries stored
  void face_compliance(const SimdBatch& theta_x, const SimdBatch& theta_y,
                       const SimdBatch& spring, SimdBatch* block) const;

private:
  mechanics::FarBoundary far_boundary_;
  BlockSymbol layers_;
};

} // namespace asperity::fem
