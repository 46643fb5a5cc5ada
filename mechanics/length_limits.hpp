#pragma once

// Limits of lengths, which are the same in a case, in a file of heights, and
// in a problem for other programs: what one command computes the others read.

namespace asperity::mechanics {

inline constexpr double least_length = 1e-16;  ///< magnitude other than 0 [m]
inline constexpr double largest_length = 1e16; ///< magnitude [m]

} // namespace asperity::mechanics
