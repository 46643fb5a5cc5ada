#pragma once

// Fits a sphere or a cylinder to a map and removes it.

#include "surfaces/maps/height_map.hpp"

namespace asperity::surfaces {

/// Subtracts the sphere of arbitrary radius and centre, or the plane that is
/// its limit, with the smallest mean square deviation along z:
///
///     z = 2 C / (1 + sqrt(1 - 2 k C)),
///     C = k (x^2 + y^2)/2 - p x - q y + d
///
/// with curvature k = 1/R, positive or negative. The four parameters are found
/// by the Gauss-Newton method, from the least-squares paraboloid of revolution.
/// The mean of the result is 0.
/// @throws std::domain_error  no sphere reaches over the whole map: the method
///                            does not converge
void remove_sphere(HeightMap& map);

/// Subtracts a cylinder whose axis has any direction in the plane,
///
///     z = b t + 2 C / (1 + sqrt(1 - 2 k C)),   C = k u^2/2 - p u + d
///     t = x cos(phi) + y sin(phi),  u = y cos(phi) - x sin(phi)
///
/// where t runs along the axis, whose inclination b is small, in the same way,
/// from the least-squares second-order form.
/// @throws std::domain_error  as remove_sphere
void remove_cylinder(HeightMap& map);

} // namespace asperity::surfaces
