#pragma once

// Knows the length units that instrument files use, in their various spellings
// and character sets.

#include <optional>
#include <string>
#include <string_view>

namespace asperity::surfaces {

/// Units for messages.
inline constexpr const char* known_length_units = "m, mm, um, nm, pm, angstrom";

/// Metres per unit: m, cm, mm, um, nm, pm, fm, km or angstrom, or the symbols
/// of micro and angstrom in UTF-8 or Latin-1. Empty if the unit is not a
/// length.
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
