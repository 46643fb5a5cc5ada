#pragma once

// "area_fraction@p=0.0129 E*": a quantity of the curve at one nominal pressure,
// and "area_fraction@p=10 MPa@zeta=10": one of the contact seen at a
// magnification; for [expect] and reference.csv. Owns spelling and names.

#include "cases/types/expectations.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::cases {

struct QuantityAtLoad {
  std::string quantity;                     ///< one of the names below
  Quantity nominal_pressure;                ///< > 0, in SI or in E*
  std::optional<double> magnification = {}; ///< zeta > 0
};

/// All dimensionless [1].
const std::vector<ExpectationName>& quantities_at_load();

/// At a load and a magnification: the load is one of [magnification].
const std::vector<ExpectationName>& quantities_at_magnification();

/// True if the name has the '@' that only these have.
bool names_a_load(const std::string& name);

/// What came of reading such a name: the quantity, or what is wrong with it.
struct QuantityAtLoadReading {
  std::optional<QuantityAtLoad> at_load;
  std::string mistake; ///< to be put behind the name
};

/// Read "name@p=number unit" or "name@p=number unit@zeta=number", blanks
/// allowed around each part. The numbers lie above 0; the unit is one of a
/// pressure, or E*.
QuantityAtLoadReading read_quantity_at_load(const std::string& name);

} // namespace asperity::cases
