#pragma once

// Numbers with the reference unit in which they are given.

namespace asperity::mechanics {

/// The reference units of a problem that a case may use besides SI.
enum class ReferenceUnit {
  si,                          ///< already in SI
  contact_modulus,             ///< "E*" [Pa]
  length,                      ///< "length", side of the periodic square [m]
  spacing,                     ///< "h", distance between neighbouring nodes [m]
  rms_height,                  ///< "h_rms" of the realisation [m]
  contact_modulus_per_spacing, ///< "E*/h" [Pa/m]
  contact_modulus_times_slope, ///< "E* h'" of the realisation [Pa]
};

/// The values of the reference units for one realisation of the surface.
struct Scales {
  double contact_modulus = 0.0; ///< E* [Pa]
  double length = 0.0;          ///< [m]
  double spacing = 0.0;         ///< h [m]
  double rms_height = 0.0;      ///< h_rms [m]
  double rms_slope = 0.0;       ///< h', both directions [1]
};

/// For what does not depend on the scales.
inline constexpr Scales unit_scales{1.0, 1.0, 1.0, 1.0, 1.0};

/// A number with its reference unit: "0.3 E*" is {0.3, contact_modulus}. It is
/// converted when the reference value is known, for measured maps only after
/// the surface is read.
struct Quantity {
  double value = 0.0;
  ReferenceUnit reference = ReferenceUnit::si;

  double in_si(const Scales& scales) const;
};

} // namespace asperity::mechanics
