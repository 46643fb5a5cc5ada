#pragma once

// Computes the contact stiffness of curves whose method does not provide it, by
// finite differences of ln p with respect to u. They are exact for the
// exponential relation that the theory predicts.

#include "results/types/result.hpp"

#include <span>
#include <vector>

namespace asperity::results {

/// Returns K = -dp_0/du = -p_0 d(ln p_0)/du at each point of a branch [Pa/m].
///
/// The derivative d(ln p_0)/du is the slope of the parabola through a point and
/// its two neighbours, for unequal steps and one-sided at both ends, or of the
/// straight line if there are only two points.
/// @param mean_gap          u, in the order of the loading path [m]
/// @param nominal_pressure  p_0 [Pa]
/// @return  as many values as points; NaN where there are fewer than two
///          points, where p_0 of the point or of a required neighbour is <= 0
///          or not finite, where two values of u are equal, or two of p_0 to
///          1e-6 of themselves
/// @throws std::domain_error  the sizes differ
/// @par Accuracy  second order in the steps of u; exact for an exponential
std::vector<double> contact_stiffness(std::span<const double> mean_gap,
                                      std::span<const double> nominal_pressure);

/// Computes each contact_stiffness that is NaN; other values are preserved.
/// Loading and unloading are separate branches.
void fill_contact_stiffness(std::vector<CurvePoint>& points);

} // namespace asperity::results
