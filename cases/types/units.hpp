#pragma once

// "14 nm", "0.3 E*": a number with a unit. Owns the table of units and the
// only lines of the program that convert one into SI.

#include "cases/types/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::cases {

enum class Dimension {
  none,            ///< [1]
  length,          ///< [m]
  pressure,        ///< [Pa]
  wavevector,      ///< [1/m], 2 pi over a wavelength
  stiffness,       ///< [Pa/m], pressure over penetration
  force,           ///< [N]
  energy_per_area, ///< [J/m^2]
  energy,          ///< [J]
  mass,            ///< [kg]
  time,            ///< [s]
  rate,            ///< [1/s]
  temperature,     ///< [K]
  density,         ///< [kg/m^3]
  viscosity,       ///< [Pa s]
};

/// A unit as a case file spells it. A number of it is worth
/// number * multiplier / divisor in SI, or in its yardstick. Two factors,
/// because powers of ten are exact upwards only: "14 nm" is 14 / 1e9, the very
/// double that 14e-9 is.
struct Unit {
  std::string symbol;
  Dimension dimension = Dimension::none;
  double multiplier = 1.0;
  double divisor = 1.0;
  Yardstick yardstick = Yardstick::si;
  bool is_alias = false; ///< another spelling, read but not listed in messages
};

/// All units, in the order messages show them.
const std::vector<Unit>& units();

/// "length", "pressure", ...
std::string dimension_name(Dimension dimension);

/// The SI unit: "m", "Pa", "1/m", "Pa/m", "N", "J/m^2", "1".
std::string si_unit(Dimension dimension);

/// "E*", "length", "h", "h_rms", "E*/h"; "" for si.
std::string yardstick_symbol(Yardstick yardstick);

/// May the unit stand behind a number of that dimension, the yardsticks being
/// those that are offered?
bool is_allowed(const Unit& unit, Dimension dimension,
                const std::vector<Yardstick>& yardsticks);

/// The symbols of the allowed units, without the aliases.
std::vector<std::string> unit_symbols(Dimension dimension,
                                      const std::vector<Yardstick>& yardsticks);

/// What came of reading a quantity: the quantity, or what is wrong with it.
struct QuantityReading {
  std::optional<Quantity> quantity;
  std::string mistake; ///< to be put behind `key = "text" `
};

/// Read "number unit", the blank between them optional. A number without a
/// unit is a mistake in a string (it is written without quotes: then it is SI).
/// The number is finite; its range is the caller's business.
QuantityReading read_quantity(const std::string& text, Dimension dimension,
                              const std::vector<Yardstick>& yardsticks);

/// The quantity as read_quantity reads it back, to the last bit: "2e-07 m".
std::string write_quantity(const Quantity& quantity, Dimension dimension);

} // namespace asperity::cases
