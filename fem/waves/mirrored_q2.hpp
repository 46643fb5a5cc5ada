#pragma once

// The surface stiffness of a Q2 block at four wavevectors, with each layer
// split into its even and odd parts under reflection about its mid-plane.

#include "fem/waves/elastic_layers.hpp"
#include "fem/waves/layer_symbol.hpp"

#include <vector>

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
/// which are all symmetric 12x12 matrices. As a function of the thickness t,
/// S = A/t + B + C t, so a material needs three symbols per wavevector for any
/// number of layers.
class MirroredQ2 {
public:
  /// @param grid  grid of the nodes of the contact surface
  MirroredQ2(const Grid& grid, const LayeredBlock& block);

  /// Computes (T_0^-1)_zz over the node classes [m/N].
  /// @param theta_x, theta_y  q times the node spacing, one wavevector per lane
  /// @param spring            spring on the uniform mode of the free components
  ///                          of the far boundary [N/m]
  /// @param block             node_kinds^2 packs, with all entries stored
  void face_compliance(const SimdBatch& theta_x, const SimdBatch& theta_y,
                       const SimdBatch& spring, SimdBatch* block) const;

  struct Layer {
    std::size_t material;
    double stretch; ///< thickness relative to the material's reference layer
  };

  /// Symbols that are proportional to the thickness, inversely proportional to
  /// it, and independent of it.
  struct Material {
    double lame_modulus, shear_modulus;
    LayerSymbol growing, falling, constant;
  };

private:
  mechanics::FarBoundary top_;
  std::vector<Layer> layers_;
  std::vector<Material> materials_;
};

} // namespace asperity::fem
