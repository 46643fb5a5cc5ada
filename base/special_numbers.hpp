#pragma once

// Names for infinity and NaN.

#include <limits>

namespace asperity {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

} // namespace asperity
