#pragma once

// Limits of numbers that the keys of a case, the computations, files of heights
// and problems for other programs have in common: what one command computes the
// others read.

namespace asperity::mechanics {

inline constexpr double least_length = 1e-16;  ///< magnitude other than 0 [m]
inline constexpr double largest_length = 1e16; ///< magnitude [m]

/// Poisson's ratio of an elastic material [1]: E and nu give moduli that are
/// positive, and not so different that roundoff decides.
inline constexpr double lowest_poisson_ratio = -0.999;
inline constexpr double highest_poisson_ratio = 0.4999;

/// Largest spread of random factors on E [1]; the smallest factor is 1 -
/// spread.
inline constexpr double largest_spread = 0.99;

} // namespace asperity::mechanics
