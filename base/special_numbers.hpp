#pragma once

// Names of the two numbers that are not finite.

#include <limits>

namespace asperity {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace asperity
