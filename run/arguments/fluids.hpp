#pragma once

// Fluids that a command names.

#include <string>
#include <vector>

namespace asperity::run {

/// The overrides of a case by which a fluid flows through its gap, under a
/// pressure drop of 100 kPa. Viscosities at 25 C and 100 kPa.
/// @param fluid  "water", "air", or a viscosity, "0.1 Pa s"
/// @throws input::InputError  it is none of them
/// @see  W. M. Haynes (ed.), CRC Handbook of Chemistry and Physics
std::vector<std::string> flow_overrides(const std::string& fluid);

} // namespace asperity::run
