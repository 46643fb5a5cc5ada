#pragma once

// The contact law of block and counterface, and the settings of its solver.

#include "mechanics/quantity.hpp"

namespace asperity::mechanics {

/// Contact law. All laws except `penalty` end at hard contact.
enum class ContactLaw {
  penalty,   ///< p = k * penetration
  hard,      ///< unilateral contact, complementarity conditions
  augmented, ///< penalty, its multiplier updated until nothing penetrates
};

/// A contact law with its penalty in SI units.
struct ContactInterface {
  ContactLaw law = ContactLaw::hard;
  double penalty = 0.0; ///< k [Pa/m] > 0; not used by hard contact
};

/// The contact law and its solver settings for an elastic method.
struct ContactSettings {
  ContactLaw law = ContactLaw::hard;
  Quantity penalty{100.0,
                   ReferenceUnit::contact_modulus_per_spacing}; ///< [Pa/m]
  double tolerance = 1e-8; ///< of complementarity, relative to h_rms and p_0
  int max_iterations = 2000;
};

} // namespace asperity::mechanics
