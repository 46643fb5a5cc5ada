#pragma once

// "area_fraction@p=0.0129 E*": a quantity of the curve at one nominal pressure,
// for [expect] and for reference.csv. Owns the spelling and the names.

#include "cases/expectations.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::cases {

struct QuantityAtLoad {
  std::string quantity;      ///< one of quantities_at_load()
  Quantity nominal_pressure; ///< > 0, in SI or in E*
};

/// All dimensionless [1].
const std::vector<ExpectationName>& quantities_at_load();

/// True if the name has the '@' that only these have.
bool names_a_load(const std::string& name);

/// What came of reading such a name: the quantity, or what is wrong with it.
struct QuantityAtLoadReading {
  std::optional<QuantityAtLoad> at_load;
  std::string mistake; ///< to be put behind the name
};

/// Read "name@p=number unit", blanks allowed around each part. The number lies
/// above 0; its unit is one of a pressure, or E*.
QuantityAtLoadReading read_quantity_at_load(const std::string& name);

} // namespace asperity::cases
