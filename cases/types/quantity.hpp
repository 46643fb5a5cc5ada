#pragma once

// A number and what it is measured in.

namespace asperity::cases {

/// The problem's own yardsticks, in which a case may measure besides SI.
enum class Yardstick {
  si,                          ///< already in SI
  contact_modulus,             ///< "E*" [Pa]
  length,                      ///< "length", side of the periodic square [m]
  spacing,                     ///< "h", distance of neighbouring nodes [m]
  rms_height,                  ///< "h_rms" of the realisation [m]
  contact_modulus_per_spacing, ///< "E*/h" [Pa/m]
};

/// The yardsticks' values for one realisation of the surface.
struct Scales {
  double contact_modulus = 0.0; ///< E* [Pa]
  double length = 0.0;          ///< [m]
  double spacing = 0.0;         ///< h [m]
  double rms_height = 0.0;      ///< h_rms [m]
};

/// A number with its yardstick: "0.3 E*" is {0.3, contact_modulus}. What is
/// known only when the surface is (measured maps) stays open until then.
struct Quantity {
  double value = 0.0;
  Yardstick yardstick = Yardstick::si;

  double in_si(const Scales& scales) const;
};

} // namespace asperity::cases
