#pragma once

// Quantities of a case: numbers with a unit of SI, "14 nm", or with one of the
// problem, "0.3 E*". The units of SI are those of input/units.hpp.

#include "input/types/case.hpp"
#include "input/units.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::cases {

using input::Dimension;
using input::si_unit;

/// Returns the symbol of a reference unit: "E*", "length", "h", "h_rms",
/// "E*/h", "E* h'"; "" for si.
std::string reference_symbol(mechanics::ReferenceUnit reference);

/// Returns the dimension of a reference unit; none for si.
Dimension reference_dimension(mechanics::ReferenceUnit reference);

/// Returns the usual units of a dimension and the allowed reference units of
/// that dimension, as messages list them.
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
