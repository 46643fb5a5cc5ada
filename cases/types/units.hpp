#pragma once

// Numbers with a unit, such as "14 nm" and "0.3 E*". Defines the table of units
// and the only conversion of units to SI.

#include "cases/types/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::cases {

enum class Dimension {
  none,                 ///< [1]
  length,               ///< [m]
  pressure,             ///< [Pa]
  wavevector,           ///< [1/m], 2 pi over a wavelength
  stiffness,            ///< [Pa/m], pressure over penetration
  force,                ///< [N]
  energy_per_area,      ///< [J/m^2]
  energy,               ///< [J]
  mass,                 ///< [kg]
  time,                 ///< [s]
  rate,                 ///< [1/s]
  temperature,          ///< [K]
  density,              ///< [kg/m^3]
  viscosity,            ///< [Pa s]
  thermal_conductivity, ///< [W/(m K)]
  resistivity,          ///< [Ohm m]
};

/// A unit as it is written in a case file. A number in this unit has the value
/// number * multiplier / divisor in SI or in its reference unit. There are two
/// factors because only positive powers of ten are exact: "14 nm" is 14 / 1e9,
/// which equals the double 14e-9 exactly.
struct Unit {
  std::string symbol;
  Dimension dimension = Dimension::none;
  double multiplier = 1.0;
  double divisor = 1.0;
  mechanics::ReferenceUnit reference = mechanics::ReferenceUnit::si;
  bool is_alias = false; ///< alternative spelling, accepted but not listed in
                         ///< messages
};

/// Returns all units in the order in which messages list them.
const std::vector<Unit>& units();

/// Returns the name of a dimension: "length", "pressure", ...
std::string dimension_name(Dimension dimension);

/// Returns the SI unit: "m", "Pa", "1/m", "Pa/m", "N", "J/m^2", "1".
std::string si_unit(Dimension dimension);

/// Returns the symbol of a reference unit: "E*", "length", "h", "h_rms",
/// "E*/h", "E* h'"; "" for si.
std::string reference_symbol(mechanics::ReferenceUnit reference);

/// Returns true if the unit may follow a number of that dimension, given the
/// allowed reference units.
bool is_allowed(const Unit& unit, Dimension dimension,
                const std::vector<mechanics::ReferenceUnit>& references);

/// Returns the symbols of the allowed units without aliases.
std::vector<std::string>
unit_symbols(Dimension dimension,
             const std::vector<mechanics::ReferenceUnit>& references);

/// The result of reading a quantity: the quantity or the mistake.
struct QuantityReading {
  std::optional<mechanics::Quantity> quantity;
  std::string mistake; ///< text that follows `key = "text" ` in a message
};

/// Reads "number unit"; the blank between them is optional. A string with a
/// number but no unit is a mistake, because a number in SI is written without
/// quotes. The number is finite; the caller checks its range.
QuantityReading
read_quantity(const std::string& text, Dimension dimension,
              const std::vector<mechanics::ReferenceUnit>& references);

/// Writes the quantity such that read_quantity() restores it to the last bit:
/// "2e-07 m".
std::string write_quantity(const mechanics::Quantity& quantity,
                           Dimension dimension);

} // namespace asperity::cases
