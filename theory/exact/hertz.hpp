#pragma once

// The Hertzian contact of an elastic half-space and a rigid sphere
// (paraboloid), and its modification for a square array of spheres on a
// periodic surface.

namespace asperity::theory {

/// One Hertzian contact. For two spheres 1/R = 1/R_1 + 1/R_2.
struct HertzContact {
  double load = 0.0;            ///< F [N]
  double sphere_radius = 0.0;   ///< R [m]
  double contact_modulus = 0.0; ///< E* [Pa]
  double contact_radius = 0.0;  ///< a, a^3 = 3 F R/(4 E*) [m]
  double peak_pressure = 0.0;   ///< p_0 = 3 F/(2 pi a^2) [Pa]
  double approach = 0.0;        ///< delta = a^2/R, positive into contact [m]
  double elastic_energy = 0.0;  ///< (2/5) F delta [J]
};

/// The contact under a load.
/// @param load             F [N] >= 0
/// @param sphere_radius    R [m] > 0
/// @param contact_modulus  E* [Pa] > 0
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  roundoff. Model: a << R, no friction, no adhesion.
/// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 4.2
HertzContact hertz_contact(double load, double sphere_radius,
                           double contact_modulus);

/// Load for a given contact radius, F = 4 E* a^3/(3 R) [N]; arguments and
/// errors as for hertz_contact(), a [m] >= 0.
double hertz_load(double contact_radius, double sphere_radius,
                  double contact_modulus);

/// Contact pressure p(r) = p_0 sqrt(1 - r^2/a^2) inside, 0 outside [Pa].
/// @param radius  r [m] >= 0, distance from the axis
double hertz_pressure(const HertzContact& contact, double radius);

/// Normal surface displacement at r, positive away from the sphere [m]:
///
///     u = pi p_0 (2 a^2 - r^2)/(4 a E*)                            r <= a
///     u = p_0 [(2 a^2 - r^2) asin(a/r) + a sqrt(r^2 - a^2)]/(2 a E*)  r > a
///
/// u(0) is the approach; for large r, u -> F/(pi E* r).
double hertz_displacement(const HertzContact& contact, double radius);

/// Gap r^2/(2R) - delta + u(r) [m], 0 inside the contact.
double hertz_gap(const HertzContact& contact, double radius);

/// Stress on the axis below the contact, tension positive.
struct AxisStress {
  double axial = 0.0;  ///< sigma_z [Pa] <= 0
  double radial = 0.0; ///< sigma_r = sigma_theta [Pa]

  /// |sigma_r - sigma_z|/2 [Pa]; its maximum is 0.310 p_0 at the depth 0.48 a
  /// for nu = 0.3.
  double largest_shear() const;
};

/// Stress on the axis:
///
///     sigma_z = -p_0/(1 + z^2/a^2),
///     sigma_r = -p_0 {(1 + nu)[1 - (z/a) atan(a/z)] - 1/(2 (1 + z^2/a^2))}.
///
/// @param depth    z [m] >= 0
/// @param poisson  nu of the half-space [1], -1 to 1/2
/// @throws std::domain_error  an argument is outside its range, or there is no
///                            contact
/// @see  K. L. Johnson, Contact Mechanics (1985), Eq. (3.45)
AxisStress hertz_axis_stress(const HertzContact& contact, double depth,
                             double poisson);

/// The constant S in the correction for the neighbours in a square array, by
/// which the approach in the array is smaller than that of an isolated sphere,
///
///     delta_isolated = delta_periodic + S F/(pi E* L),
///     S = lim [integral - sum of 1/n over the square lattice but its origin]
///       = -4 zeta(1/2) beta(1/2) = 3.9002649200019564,
///
/// evaluated to roundoff as a sum of complementary error functions.
double square_array_constant();

/// The correction S F/(pi E* L) [m]. Added to the approach of a periodic cell
/// whose uniform displacement is removed (delta_periodic = crest height above
/// its mean plane minus the mean gap), it gives the approach of a single
/// isolated sphere.
///
/// @param load             F on each cell [N] >= 0
/// @param contact_modulus  E* [Pa] > 0
/// @param period           L, side of the square cell [m] > 0
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  the remaining relative error of delta is O((a/L)^3), because
///            the neighbours also curve the surface under the sphere;
///            square_array_contact() includes this effect.
double square_array_approach(double load, double contact_modulus,
                             double period);

/// T = sum of n^-3 over the square lattice but its origin
///   = 4 zeta(3/2) beta(3/2), to roundoff.
double square_array_curvature_constant();

/// Contact of one sphere of a square array.
struct SquareArrayContact {
  HertzContact spot;     ///< Hertzian contact with the radius R' below
  double approach = 0.0; ///< delta_periodic, uniform displacement removed [m]
};

/// The neighbours of each sphere displace the surface below it by
///     F/(pi E* L) [-S + (T/4)(r^2 + 2 a^2/5)/L^2 + O((a/L)^4)],
/// so that the contact is Hertzian with 1/R' = 1/R + T F/(2 pi E* L^3), and
///     delta_periodic = a^2/R' - F/(pi E* L) [S - T a^2/(10 L^2)].
///
/// @param load, sphere_radius, contact_modulus  as in hertz_contact(), per cell
/// @param period  L, side of the square cell [m] > 0
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  error 1.1 (a/L)^5 of the approach, measured up to a/L = 0.3
SquareArrayContact square_array_contact(double load, double sphere_radius,
                                        double contact_modulus, double period);

} // namespace asperity::theory
