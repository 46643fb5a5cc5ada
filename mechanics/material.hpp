#pragma once

// The material of the block and of its counterface: moduli, bonded layers, an
// inclusion, and the variation of Young's modulus with the place.

#include "mechanics/quantity.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity::mechanics {

/// The elastic constants of an isotropic body.
struct BodyModuli {
  double youngs_modulus = 0.0; ///< E [Pa] > 0
  double poisson_ratio = 0.0;  ///< nu [1], -1..0.5
};

/// One entry of material.layers, ordered from the contact surface. Below the
/// last layer the block has the constants of [material].
struct MaterialLayer {
  Quantity thickness; ///< [m] > 0
  BodyModuli moduli;
};

/// [material.inclusion]: a spherical inclusion below the centre of the contact
/// surface.
struct MaterialInclusion {
  Quantity radius; ///< [m] > 0
  Quantity depth;  ///< depth of the centre [m] > radius
  BodyModuli moduli;
};

enum class VariationKind { function, random, table };

/// [material.variation]: E(x) is E times a factor; nu is constant.
struct MaterialVariation {
  VariationKind kind = VariationKind::function;
  std::string factor; ///< function of x, y, z, each divided by length; z = 0 is
                      ///< the contact surface
  double spread = 0.0;    ///< random: factor per cell in 1 - spread..1 + spread
  std::uint64_t seed = 0; ///< seed of the random factors
  /// Edge of the cubes that share a random factor [m] > 0; unset, each cell has
  /// its own factor.
  std::optional<Quantity> edge = {};
  std::string file; ///< file of the table; the reader makes the path absolute
                    ///< or relative to the working directory
};

/// [material]: a block in contact with a rigid counter-surface, or two elastic
/// bodies reduced to one: 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2.
struct MaterialSpec {
  double contact_modulus = 0.0;        ///< E* [Pa] > 0, of the pair
  std::optional<double> poisson_ratio; ///< of the block, -1 < nu < 0.5

  std::optional<BodyModuli> counter = {}; ///< the second body, which E*
                                          ///< includes
  std::vector<MaterialLayer> layers = {};
  std::optional<MaterialInclusion> inclusion = {};
  std::optional<MaterialVariation> variation = {};

  /// Returns true if modulus and Poisson's ratio are uniform, as theory,
  /// half-space and atoms assume.
  bool is_uniform() const { return layers.empty() && !inclusion && !variation; }

  /// Returns E = E* (1 - nu^2) [Pa], Young's modulus of the single block that
  /// is equivalent to the pair. Needs poisson_ratio.
  double block_youngs_modulus() const;

  /// Returns the moduli of the first of two bodies, obtained from E* by
  /// removing the contribution of the second body; without a second body, those
  /// of the single block. Needs poisson_ratio.
  BodyModuli first_body() const;
};

} // namespace asperity::mechanics
