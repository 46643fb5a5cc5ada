#pragma once

// The list of the methods, and the questions that the rest of the program asks
// of any method.

#include "mechanics/contact_nodes.hpp"
#include "mechanics/continuum_settings.hpp"
#include "mechanics/fem_settings.hpp"
#include "mechanics/md_settings.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <variant>

namespace asperity::cases {

/// The list of the methods. A new one is added here; the compiler then names
/// each function that has no answer for it (docs/extending.md).
using MethodSettings =
    std::variant<mechanics::TheorySettings, mechanics::HalfspaceSettings,
                 mechanics::FemSettings, mechanics::MdSettings,
                 mechanics::WinklerSettings>;

/// Returns the table of a method, "fem" for "fem.hard".
inline std::string kind_of_method(const std::string& name) {
  return name.substr(0, name.find('.'));
}

/// One method to run. A table [fem] is the method "fem"; a table inside it,
/// [fem.hard], is the method "fem.hard", which has the keys of [fem] with its
/// own keys taking precedence.
struct MethodSpec {
  std::string name;
  MethodSettings settings;
  /// zeta: for a self-affine surface, this method omits roughness above zeta
  /// q_0. Phases and amplitudes of the remaining roughness do not change.
  std::optional<double> magnification = {};
  /// The number of realisations that this method solves, beginning with the
  /// first; the surface may have fewer. Default: all.
  std::optional<int> realizations = {};

  /// Returns the settings of this kind of method; null for another one.
  template <class Settings>
  const Settings* as() const {
    return std::get_if<Settings>(&settings);
  }

  /// Returns whether the method solves for a pressure and gap field.
  bool has_fields() const {
    return std::visit([](const auto& own) { return own.has_fields(); },
                      settings);
  }

  /// Returns whether the method needs the heights of each realisation.
  bool needs_surface() const {
    return std::visit([](const auto& own) { return own.needs_surface(); },
                      settings);
  }

  /// Returns whether the method needs material.poisson_ratio.
  bool needs_poisson_ratio() const {
    return std::visit([](const auto& own) { return own.needs_poisson_ratio(); },
                      settings);
  }

  /// Returns whether the pressure acts on an elastic continuum, or on atoms
  /// that approximate one: whether there is a stress inside.
  bool is_continuum() const {
    return std::visit([](const auto& own) { return own.is_continuum(); },
                      settings);
  }

  /// Returns the contact of a half-space or block; null for others.
  const mechanics::ContactSettings* contact() const {
    if (const auto* half = as<mechanics::HalfspaceSettings>())
      return &half->contact;
    const auto* const block = as<mechanics::FemSettings>();
    return block != nullptr ? &block->contact : nullptr;
  }

  /// Returns whether the faces attract each other.
  bool is_adhesive() const {
    if (const auto* const md = as<mechanics::MdSettings>())
      return md->is_adhesive();
    return contact() != nullptr && mechanics::is_adhesive(contact()->law);
  }

  /// Returns the law of faces that attract each other, of atoms that of flat
  /// faces; none without adhesion.
  /// @param scales  with a length and a spacing > 0
  std::optional<mechanics::ContactInterface>
  adhesion(const mechanics::Scales& scales) const {
    if (const auto* const md = as<mechanics::MdSettings>())
      return md->flat_law(scales.length, static_cast<int>(std::lround(
                                             scales.length / scales.spacing)));
    return is_adhesive() ? std::optional(contact()->in_si(scales))
                         : std::nullopt;
  }

  /// Returns how contact is decided in the fields of the method.
  /// @param rms_height  of its surface [m]
  mechanics::ContactCriterion contact_criterion(double rms_height) const {
    using mechanics::ContactField;
    const bool is_atomic =
        std::holds_alternative<mechanics::MdSettings>(settings);
    return {is_atomic || is_adhesive() ? ContactField::gap
                                       : ContactField::pressure,
            contact() != nullptr ? contact()->tolerance * rms_height : 0.0};
  }

  /// Returns what lies beyond the border of the fields of the method.
  mechanics::Border border() const {
    const auto* half = as<mechanics::HalfspaceSettings>();
    const auto* fem = as<mechanics::FemSettings>();
    const bool is_free = (half != nullptr && half->block().is_free()) ||
                         (fem != nullptr && fem->has_free_sides());
    return is_free ? mechanics::Border::free : mechanics::Border::periodic;
  }

  /// Returns the largest pressure of the method; none if it is elastic.
  std::optional<mechanics::Quantity> hardness() const {
    if (const auto* half = as<mechanics::HalfspaceSettings>())
      return half->contact.hardness;
    const auto* const theory = as<mechanics::TheorySettings>();
    return theory != nullptr ? theory->hardness : std::nullopt;
  }

  /// Returns whether the method uses [[material.layers]].
  bool uses_layers() const {
    return std::visit([](const auto& own) { return own.uses_layers(); },
                      settings);
  }
};

} // namespace asperity::cases
