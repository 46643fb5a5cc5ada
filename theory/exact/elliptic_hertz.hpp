#pragma once

// The Hertzian contact of an elastic half-space and a rigid body with two
// different principal curvatures; the contact area is an ellipse.

namespace asperity::theory {

/// One elliptic Hertzian contact, p = p_0 sqrt(1 - x^2/a^2 - y^2/b^2).
struct EllipticContact {
  double load = 0.0;          ///< F = (2 pi/3) a b p_0 [N]
  double major_radius = 0.0;  ///< a, along the smaller curvature [m]
  double minor_radius = 0.0;  ///< b <= a [m]
  double peak_pressure = 0.0; ///< p_0 [Pa]
};

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

/// The contact at a given approach.
/// @param approach         delta [m] >= 0
/// @param curvatures       k_1, k_2 of the body [1/m] > 0, in either order
/// @param contact_modulus  E* [Pa] > 0
/// @throws std::domain_error  an argument is outside its range or not finite
EllipticContact elliptic_contact(double approach, double first_curvature,
                                 double second_curvature,
                                 double contact_modulus);

} // namespace asperity::theory
