#pragma once

// Range checks for the arguments of public functions, which throw a
// std::domain_error that names the argument, its value and the allowed range.

#include <string>

namespace asperity {

/// A number of a message: the shortest text that reads back as the same number,
/// so that it differs from every other one, such as the limit that it exceeds.
std::string number_text(double value);

/// A measured number beside its limit: at least `digits` significant digits,
/// and as many more as it takes to tell it from the limit with the same digits.
std::string number_text(double value, double limit, int digits);

/// @throws std::domain_error  "name = value, but must be <range>"
[[noreturn]] void refuse_argument(const std::string& name, double value,
                                  const std::string& range);

/// These functions reject a value that is outside its range or not finite;
/// `unit` is printed in the message, "1" if dimensionless.
void require_positive(const char* name, double value, const char* unit);
void require_not_negative(const char* name, double value, const char* unit);

/// Requires low <= value <= high.
void require_between(const char* name, double value, double low, double high,
                     const char* unit);

} // namespace asperity
