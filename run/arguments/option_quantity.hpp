#pragma once

// Quantities with units that are given as options on the command line.

#include "cases/types/units.hpp"

#include <string>

namespace asperity::run {

/// Returns the quantity in SI units.
/// @param option  name of the option, for messages: "--contact-modulus"
/// @param text    number and unit: "2 GPa"
/// @throws input::InputError  no number with a unit of the dimension, or the
///                            number is not above 0
double positive_quantity(const std::string& option, const std::string& text,
                         cases::Dimension dimension);

} // namespace asperity::run
