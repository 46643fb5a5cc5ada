#pragma once

// Quantities at one load, for [expect] and reference.csv:
// "area_fraction@p=0.0129 E*" is a quantity of the curve at one nominal
// pressure, "area_fraction@p=10 MPa@zeta=10" one of the contact at a
// magnification. Defines their syntax.

#include "input/types/expectations.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::cases {

struct QuantityAtLoad {
  std::string quantity; ///< of expectation_names(), dimensionless [1]
  mechanics::Quantity nominal_pressure;     ///< > 0, in SI or in E*
  std::optional<double> magnification = {}; ///< zeta > 0
};

/// Returns true if the name contains '@', which only these names do.
bool names_a_load(const std::string& name);

/// The result of reading such a name: the quantity or the mistake.
struct QuantityAtLoadReading {
  std::optional<QuantityAtLoad> at_load;
  std::string mistake; ///< text that follows the name in a message
};

/// Reads "name@p=number unit" or "name@p=number unit@zeta=number" with optional
/// blanks around each part. The numbers must be > 0; the unit is a pressure
/// unit or E*.
QuantityAtLoadReading read_quantity_at_load(const std::string& name);

} // namespace asperity::cases
