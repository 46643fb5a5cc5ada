#pragma once

// Lengths and numbers in the files of instruments.

#include <optional>
#include <string>
#include <string_view>

namespace asperity::surfaces {

/// The usual units of length, for messages.
std::string known_length_units();

/// Metres per unit, by the table of units (input/units.hpp). Empty if the unit
/// is not a length.
std::optional<double> length_unit(std::string_view unit);

/// Reads "20.0 um" or, if decimal commas are allowed, "20,0 um" [m]; empty if
/// the text is anything else or the number is not finite.
std::optional<double> length_of_text(std::string_view text);

/// With small letters for the capital ones of ASCII.
std::string lower_case(std::string_view text);

/// The number represented by the whole word, with a decimal point or with one
/// decimal comma; NaN if it represents none. Infinities are numbers.
double number_of_text(std::string_view word);

} // namespace asperity::surfaces
