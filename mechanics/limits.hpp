#pragma once

// Limits of numbers that both the keys of a case and the computations have.

namespace asperity::mechanics {

/// Poisson's ratio of an elastic material [1]: E and nu give moduli that are
/// positive, and not so different that roundoff decides.
inline constexpr double lowest_poisson_ratio = -0.999;
inline constexpr double highest_poisson_ratio = 0.4999;

/// Largest spread of random factors on E [1]; the smallest factor is 1 -
/// spread.
inline constexpr double largest_spread = 0.99;

} // namespace asperity::mechanics
