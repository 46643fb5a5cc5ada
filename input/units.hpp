#pragma once

// The one table of units. Whatever reads a number with a unit, in a case, an
// option, a height map, a line scan or a measured curve, finds the unit here.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::input {

enum class Dimension {
  none,                 ///< [1]
  length,               ///< [m]
  area,                 ///< [m^2]
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

/// A unit. One of it is factor * 10^decade in SI. The power of ten stands alone
/// because only positive ones are exact: "14 nm" is 14 / 1e9, which equals the
/// double 14e-9 exactly.
struct Unit {
  std::string_view symbol;
  Dimension dimension = Dimension::none;
  int decade = 0;
  double factor = 1.0;
  bool is_usual = false; ///< listed in messages; the others are accepted, too

  /// Returns the value of a number in this unit, which may overflow.
  double in_si(double number) const;
};

/// Returns all units, those of one dimension together, its SI unit first.
const std::vector<Unit>& units();

/// Returns the unit of this name; null if there is none. The name may have
/// blanks at its ends, the symbols of micro and angstrom and the superscripts
/// of UTF-8 or Latin-1, a dot or a star for a product, and exponents without
/// '^': "µm²", "N/mm2" and "Pa.s" are "um^2", "N/mm^2" and "Pa s".
const Unit* unit_called(std::string_view name);

/// Returns what one unit of this name is in SI; empty if there is no such unit
/// of this dimension.
std::optional<double> unit_in_si(std::string_view name, Dimension dimension);

/// Returns the name of a dimension: "length", "pressure", ...
std::string dimension_name(Dimension dimension);

/// Returns it with its article: "a length", "an energy", ...
std::string with_article(Dimension dimension);

/// Returns the SI unit: "m", "Pa", "1/m", "Pa/m", "N", "J/m^2", "1".
std::string si_unit(Dimension dimension);

/// Returns the usual units of a dimension as messages list them.
std::vector<std::string> usual_units(Dimension dimension);

/// Returns the nearest unit of this dimension, and never one of another.
/// @param symbols  others that are allowed, too, and preferred
std::string nearest_unit(const std::string& name, Dimension dimension,
                         std::vector<std::string> symbols = {});

/// A text that is split into its number and the name of its unit.
struct NumberWithUnit {
  double number = 0.0;
  std::string unit; ///< without blanks at its ends; may be empty
  /// Why there is no finite number, as text behind the quoted one; else empty.
  std::string mistake;
};

/// Splits "number unit"; the blank between them is optional.
/// @param dimension  of the units that are taken for one without a number
NumberWithUnit split_number(const std::string& text, Dimension dimension);

/// Returns why a unit is refused where one of `allowed` must be, as text behind
/// the quoted one.
std::string unit_mistake(const std::string& unit, Dimension dimension,
                         const std::vector<std::string>& allowed);

/// The value in SI, or the mistake as text behind the quoted one.
struct ValueReading {
  std::optional<double> value;
  std::string mistake;
};

/// Reads a number that must have a unit of this dimension.
ValueReading read_with_unit(const std::string& text, Dimension dimension);

} // namespace asperity::input
