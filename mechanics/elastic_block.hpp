#pragma once

// A laterally uniform elastic block in SI units: a half-space or a block of
// finite thickness, with bonded layers.

#include "mechanics/far_boundary.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace asperity::mechanics {

/// A homogeneous, isotropic layer, bonded to the material below it.
struct BondedLayer {
  double thickness = 0.0;      ///< [m] > 0
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1], -1 < nu <= 0.5
};

/// An isotropic elastic block with a frictionless surface and bonded layers.
/// The operators of a half-space or slab are made from it, and the texts, the
/// problems for other programs and the certificates that state what was solved
/// ask it.
struct ElasticBlock {
  double contact_modulus = 0.0; ///< E* = E/(1 - nu^2) below the layers [Pa] > 0
  /// Below the layers [1]; read if there are layers or if the far boundary is
  /// clamped.
  double poisson_ratio = 0.0;
  double thickness = 0.0; ///< with layers [m] > 0; infinite for a half-space
  FarBoundary far_boundary = FarBoundary::clamped;
  std::vector<BondedLayer> layers = {}; ///< from the contact surface downwards
  /// Of the contact surface; free only if is_halfspace().
  Border border = Border::periodic;

  bool is_infinite() const { return std::isinf(thickness); }

  /// Whether C(q) = 2/(E* q): E* and the border are then all that counts.
  bool is_halfspace() const { return is_infinite() && layers.empty(); }

  bool is_free() const { return border == Border::free; }

  /// "half-space" or "slab".
  const char* name() const { return is_infinite() ? "half-space" : "slab"; }
};

/// The uniform half-space.
/// @param contact_modulus  E* [Pa] > 0
inline ElasticBlock halfspace(double contact_modulus,
                              Border border = Border::periodic) {
  ElasticBlock block;
  block.contact_modulus = contact_modulus;
  block.thickness = std::numeric_limits<double>::infinity();
  block.border = border;
  return block;
}

} // namespace asperity::mechanics
