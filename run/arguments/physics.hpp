#pragma once

// Overrides of a case by which a command adds a physical effect to it.

#include "input/types/case.hpp"
#include "input/units.hpp"

#include <string>
#include <vector>

namespace asperity::run {

/// A fluid flows through the gap, under a pressure drop of 100 kPa. Viscosities
/// at 25 C and 100 kPa.
/// @param fluid  "water", "air", or a viscosity, "0.1 Pa s"
/// @throws input::InputError  it is none of them
/// @see  W. M. Haynes (ed.), CRC Handbook of Chemistry and Physics
std::vector<std::string> flow_overrides(const std::string& fluid);

/// The loads of a run with adhesion: those of the case, mean gaps from 4 h_rms
/// to 0.5 h_rms and back, or pressures from 0.001 E* h' to 0.3 E* h' and back.
enum class AdhesivePath { of_case, by_gap, by_pressure };

/// The faces of a half-space attract each other by the exponential law, over
/// the shortest range that the grid resolves.
/// @param work  of adhesion, "50 mJ/m^2"
/// @param path  a map has gaps, with free edges pressures
/// @throws input::InputError  it is no work of adhesion
std::vector<std::string> adhesion_overrides(const std::string& work,
                                            AdhesivePath path);

/// The loads of maps that are pressed with a hardness: no surface carries a
/// nominal pressure above it. The range is that of maps without a hardness as
/// far as it stays below 90 % of the hardness, for the map with the largest
/// slope.
/// @param presses  the case of each map, with the loads of maps
/// @return  an override of the loads; "" if they are below the hardness
std::string loads_below_hardness(const std::vector<cases::Case>& presses);

/// Returns the quantity in SI units.
/// @param option  name of the option, for messages: "--contact-modulus"
/// @param text    number and unit: "2 GPa"
/// @throws input::InputError  no number with a unit of the dimension, or the
///                            number is not above 0
double positive_quantity(const std::string& option, const std::string& text,
                         input::Dimension dimension);

/// Returns the unit of length that an option gives, as a quantity of a case:
/// "1 nm" for "nm", and "2 nm" as it is.
/// @throws input::InputError  it is no unit of length
std::string length_unit_text(const std::string& option,
                             const std::string& unit);

} // namespace asperity::run
