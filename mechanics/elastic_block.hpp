#pragma once

// A laterally uniform elastic block in SI units: a half-space or a block of
// finite thickness, with bonded layers.

#include "mechanics/far_boundary.hpp"

#include <vector>

namespace asperity::mechanics {

/// A homogeneous, isotropic layer, bonded to the material below it.
struct BondedLayer {
  double thickness = 0.0;      ///< [m] > 0
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1], -1 < nu <= 0.5
};

/// An isotropic elastic block with a frictionless surface and bonded layers.
struct ElasticBlock {
  double contact_modulus = 0.0; ///< E* = E/(1 - nu^2) below the layers [Pa] > 0
  /// Below the layers [1]; read if there are layers or if the far boundary is
  /// clamped.
  double poisson_ratio = 0.0;
  double thickness = 0.0; ///< with layers [m] > 0; infinite for a half-space
  FarBoundary far_boundary = FarBoundary::clamped;
  std::vector<BondedLayer> layers = {}; ///< from the contact surface downwards
};

} // namespace asperity::mechanics
