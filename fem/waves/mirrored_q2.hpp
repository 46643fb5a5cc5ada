#pragma once

// The surface stiffness of a Q2 block at four wavevectors, each layer split
// into its parts even and odd under reflection in its middle plane.

#include "fem/waves/elastic_layers.hpp"
#include "fem/waves/layer_symbol.hpp"

#include <vector>

namespace asperity::fem {

/// T_0 of (Q2.2) by layers that are mirror images of themselves. Let P turn the
/// sign of u_z, p be the components in the plane and v = u_z. The planes' even
/// part (p alike, v opposite) stretches p of the half-way nodes alone, the odd
/// part v alone; with these eliminated, both of a layer's planes have
///
///     F = S_tt   - X^T S_pp^-1 X - Y^T S_vv^-1 Y,                   (Q2.4)
///     H = S_tb P - X^T S_pp^-1 X + Y^T S_vv^-1 Y,
///     X = S_mt of the half-way p, Y of the half-way v,
///     T_l = P [ F - H (F + T_(l+1))^-1 H ] P,                       (Q2.5)
///
/// all symmetric 12x12. S = A/t + B + C t in the thickness, so a material
/// needs three symbols a wavevector whatever its layers.
class MirroredQ2 {
public:
  /// @param grid   of the nodes of the contact face
  MirroredQ2(const Grid& grid, const LayeredBlock& block);

  /// (T_0^-1)_zz over the kinds [m/N].
  /// @param theta_x, theta_y  q times the node spacing, a wavevector a lane
  /// @param spring  on the uniform mode of the top's free components [N/m]
  /// @param block   node_kinds^2 packs, full
  void face_compliance(const Pack& theta_x, const Pack& theta_y,
                       const Pack& spring, Pack* block) const;

  struct Layer {
    std::size_t material;
    double stretch; ///< thickness over the materials' own
  };

  /// Symbols that grow with the thickness, fall with it, and do not know it.
  struct Material {
    double lame_modulus, shear_modulus;
    LayerSymbol growing, falling, constant;
  };

private:
  cases::TopFace top_;
  std::vector<Layer> layers_;
  std::vector<Material> materials_;
};

} // namespace asperity::fem
