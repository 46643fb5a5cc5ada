#pragma once

// Reads the quantities that options give.

#include "input/units.hpp"

#include <string>

namespace asperity::run {

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
