#pragma once

// The flow through a gap of which only the distribution is known, by
// Bruggeman's effective medium.

#include <span>

namespace asperity::flow {

/// Conductance of a square of the effective medium [m^3], 12 eta = Dp = 1: the
/// K > 0 for which patches of all gaps, embedded in a medium with K, disturb
/// its flow by nothing on average. In two dimensions
///
///     sum_i s_i (u_i^3 - K)/(u_i^3 + K) = A/A_0,
///
/// where the closed share A/A_0 is 1 - sum_i s_i. K is 0 if half of the area or
/// more is closed: this medium percolates at 1/2.
/// @param gaps    u_i [m] >= 0; a gap of 0 is closed
/// @param shares  s_i of the nominal area [1] >= 0 with a sum of at most 1
/// @throws std::domain_error  the sizes differ
/// @see  D. A. G. Bruggeman, Ann. Phys. 416, 636 (1935); for leakage B. N. J.
///       Persson, C. Yang, J. Phys.: Condens. Matter 20, 315011 (2008)
double effective_medium(std::span<const double> gaps,
                        std::span<const double> shares);

/// The same for a map, whose nodes have equal shares; closed where <= 0.
double effective_medium(std::span<const double> gap);

} // namespace asperity::flow
