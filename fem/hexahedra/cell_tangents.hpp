#pragma once

// The stiffness of a cell whose material law is not linear, which differs
// between its Gauss points.

#include "fem/hexahedra/hexahedron_kernel.hpp"

#include <array>
#include <cstddef>

namespace asperity::fem {

/// The change of the stress with the strain at a point of an isotropic body
/// that flows:
///
///     dsigma = lambda tr(de) I + 2 mu de - s (s : de),                 (F.6)
///
/// with a symmetric tensor s. An elastic point has s = 0. The consistent
/// tangent of J2 flow by radial return (Simo and Hughes, Computational
/// Inelasticity, 1998, Box 3.2: moduli kappa and mu, factors theta and
/// theta-bar, flow direction n) has lambda = kappa - 2 mu theta / 3, the shear
/// modulus mu theta, and s = sqrt(2 mu theta-bar) n.
struct PointTangent {
  double lame = 0.0;  ///< lambda [Pa]
  double shear = 0.0; ///< mu [Pa]
  /// s_xx, s_yy, s_zz, s_yz, s_zx, s_xy [sqrt(Pa)]
  std::array<double, 6> softening{};
};

/// A hexahedron with tangents of its own; one of first order has the first
/// eight points.
struct CellTangents {
  std::size_t cell = 0;
  std::array<PointTangent, points_in_hexahedron> points; ///< x fastest
};

} // namespace asperity::fem
