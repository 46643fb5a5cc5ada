#pragma once

// The Hertzian contact of an elastic half-space and a rigid body with two
// different principal curvatures; the contact area is an ellipse.

namespace asperity::theory {

/// Factors relative to a sphere: with the mean curvature t = (k_1 + k_2)/2 and
/// the approach delta,
///     F = (4/3) E* delta^{3/2} t^{-1/2} load_factor,
///     pi a b = pi (delta/t) area_factor.
/// Both factors are 1 for a sphere.
struct EllipticFactors {
  double squared_eccentricity = 0.0; ///< m = 1 - b^2/a^2 [1]
  double load_factor = 1.0;          ///< (pi/2) E^{1/2} K^{-3/2} (1 - m)^{-1/2}
  double area_factor = 1.0;          ///< (E/K) (1 - m)^{-1/2}
};

/// Shape of the contact ellipse, from the root m of
///
///     (k_1 - k_2)/(k_1 + k_2) = [(2 - m) E(m) - 2 (1 - m) K(m)]/(m E(m)),
///
/// with the complete elliptic integrals K and E.
/// @param curvature_contrast  abs(k_1 - k_2)/(k_1 + k_2) [1], at least 0 and
///                            below 1
/// @throws std::domain_error  the contrast is outside its range
/// @par Accuracy  roundoff divided by m, about 1e-13
/// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 4.2(c)
EllipticFactors elliptic_factors(double curvature_contrast);

} // namespace asperity::theory
