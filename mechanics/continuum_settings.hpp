#pragma once

// The settings of the methods that need no mesh: the theory, the half-space and
// the Winkler foundation.

#include "mechanics/contact_law.hpp"
#include "mechanics/elastic_block.hpp"
#include "mechanics/quantity.hpp"

#include <optional>

namespace asperity::mechanics {

enum class TheorySpectrum { formula, surface };

/// Laws of the loss factor: Eq. (10) of Yang and Persson (2008), Wang and
/// Mueser (2017), Xu et al. (2024); theory/persson/loss_law.hpp has the latter
/// two.
enum class LossFactor { yang_persson, wang_mueser, xu };

struct TheorySettings {
  double gamma = 0.0; ///< 0 < gamma <= 1, parameter of the loss factor
  TheorySpectrum spectrum = TheorySpectrum::formula;
  LossFactor loss_factor = LossFactor::yang_persson;
  /// H [Pa] > 0, the second absorbing boundary of the stress: of the areas
  /// only.
  std::optional<Quantity> hardness = {};

  static constexpr const char* kind = "theory";

  bool has_fields() const { return false; }

  bool needs_surface() const { return spectrum == TheorySpectrum::surface; }

  bool needs_poisson_ratio() const { return false; }

  bool uses_layers() const { return false; }

  bool is_continuum() const { return false; }
};

struct HalfspaceSettings {
  ContactSettings contact;
  std::optional<Quantity> thickness;               ///< none: half-space [m]
  FarBoundary far_boundary = FarBoundary::clamped; ///< if there is a thickness
  /// The surface is pressed once on an infinite half-space, without its
  /// periodic continuation.
  bool has_free_boundaries = false;

  static constexpr const char* kind = "halfspace";

  bool has_fields() const { return true; }

  bool needs_surface() const { return true; }

  bool needs_poisson_ratio() const { return thickness.has_value(); }

  /// The block without its material. Whether it is infinite, its name and its
  /// border do not depend on the scales.
  ElasticBlock block(const Scales& scales = unit_scales) const {
    ElasticBlock own =
        halfspace(0.0, has_free_boundaries ? Border::free : Border::periodic);
    if (thickness)
      own.thickness = thickness->in_si(scales);
    own.far_boundary = far_boundary;
    return own;
  }

  bool uses_layers() const { return true; }

  bool is_continuum() const { return true; }
};

/// [winkler]: independent springs under the nodes, in hard contact.
struct WinklerSettings {
  Quantity stiffness; ///< k [Pa/m] > 0

  static constexpr const char* kind = "winkler";

  bool has_fields() const { return true; }

  bool needs_surface() const { return true; }

  bool needs_poisson_ratio() const { return false; }

  bool uses_layers() const { return false; }

  bool is_continuum() const { return false; }
};

} // namespace asperity::mechanics
