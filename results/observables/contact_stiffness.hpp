#pragma once

// The contact stiffness of a curve whose method does not give it: differences
// of ln p against u, which are exact for the exponential the theory predicts.

#include "results/types/result.hpp"

#include <span>
#include <vector>

namespace asperity::results {

/// K = -dp_0/du = -p_0 d(ln p_0)/du at each point of a branch [Pa/m].
///
/// d(ln p_0)/du is the slope of the parabola through a point and its two
/// neighbours, one-sided at both ends (for unequal steps), the line through
/// both of two points.
/// @param mean_gap          u, in the order of the load program [m]
/// @param nominal_pressure  p_0 [Pa]
/// @return  as long as the curve; NaN where there is nothing to take: fewer
///          than two points, p_0 <= 0 or not finite there or at a neighbour it
///          needs, two equal u
/// @throws std::domain_error  the sizes differ
/// @par Accuracy  second order in the steps of u; exact for an exponential
std::vector<double> contact_stiffness(std::span<const double> mean_gap,
                                      std::span<const double> nominal_pressure);

/// Fills the contact_stiffness that is NaN; others stay. Loading and unloading
/// are two branches.
void fill_contact_stiffness(std::vector<CurvePoint>& points);

} // namespace asperity::results
