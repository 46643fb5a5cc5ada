#pragma once

// Huber's closed form of the stress and the displacement below a Hertzian
// contact, anywhere in the half-space; hertz.hpp has the values on the surface
// and on the axis.

#include "theory/exact/hertz.hpp"

namespace asperity::theory {

/// Stress at one point of an axisymmetric state, tension positive [Pa].
struct AxisymmetricStress {
  double radial = 0.0; ///< sigma_r
  double hoop = 0.0;   ///< sigma_theta
  double axial = 0.0;  ///< sigma_z
  double shear = 0.0;  ///< tau_rz, z into the body

  /// Von Mises stress sqrt(3 J_2) [Pa] >= 0.
  double von_mises() const;

  /// Half the difference of the largest and the smallest principal stress
  /// [Pa] >= 0.
  double largest_shear() const;
};

/// Stress of the frictionless Hertzian contact, r from the axis and z into the
/// body. With p_m = 2 p_0/3, s = r^2 + z^2 - a^2,
/// u = (s + sqrt(s^2 + 4 a^2 z^2))/2 and k = z/sqrt(u):
///
///     sigma_z/p_m = -(3/2) k^3 a^2 u/(u^2 + a^2 z^2)
///     tau_rz/p_m  = -(3/2) r z^2/(u^2 + a^2 z^2) a^2 sqrt(u)/(a^2 + u)
///     sigma_r/p_m =  (3/2) [H + k^3 a^2 u/(u^2 + a^2 z^2)
///                           + k (B + (1 - nu) u/(a^2 + u) - 2)]
///     sigma_theta/p_m = -(3/2) [H + k (2 nu + (1 - nu) u/(a^2 + u) - B)]
///
/// with H = (1 - 2 nu)/3 a^2/r^2 (1 - k^3),
/// B = (1 + nu) sqrt(u)/a atan(a/sqrt(u)). Cancellation is avoided near the
/// axis by 1 - k^2 = r^2/(a^2 + u), and far from the contact by the series of
/// 1 - sqrt(u)/a atan(a/sqrt(u)).
///
/// @param radius   r [m] >= 0
/// @param depth    z [m] >= 0; on the surface k is 0 outside the contact and
///                 sqrt(1 - r^2/a^2) inside
/// @param poisson  nu of the body [1], -1 <= nu <= 0.5
/// @throws std::domain_error  an argument is outside its range or not finite,
///                            or there is no contact
/// @par Accuracy  1e-12 p_0 near the contact, 1e-12 of the stress of a point
///            load far from it; at the contact edge the square root of roundoff
/// @see  M. T. Huber, Ann. Phys. 319, 153 (1904); A. C. Fischer-Cripps,
///       Introduction to Contact Mechanics (2007), Sec. 5.4
AxisymmetricStress hertz_stress(const HertzContact& contact, double radius,
                                double depth, double poisson);

/// Displacement at one point of an axisymmetric state [m].
struct AxisymmetricDisplacement {
  double radial = 0.0; ///< u_r, away from the axis
  double axial = 0.0;  ///< u_z, into the body
};

/// The displacement that belongs to hertz_stress(), 0 at infinity:
///
///     u_r = (p_0/E*) [z r/a I - (1 - 2 nu)/(1 - nu) a^2 (1 - k^3)/(3 r)]
///     u_z = (p_0/2E*) [2 a A - r^2/a I + 2 nu/(1 - nu) z k (1 - A sqrt(u)/a)]
///
/// with A = atan(a/sqrt(u)), I = A - a sqrt(u)/(a^2 + u). They follow from
/// Boussinesq's potentials of the pressure, V = int p/rho dS and Psi,
/// dPsi/dz = V (Johnson, Sec. 3.2): V is that of a flattened ellipsoid,
///
///     V = (pi p_0/2a) int_u^inf [1 - r^2/(a^2 + s) - z^2/s]
///                               a^2 ds/((a^2 + s) sqrt(s)),
///
/// and r dPsi/dr = -int_0^r r' dV/dz dr'. On the surface u_z is
/// hertz_displacement() and u_r = -(1 - 2 nu)/(1 - nu) p_0 a^2
/// (1 - k^3)/(3 E* r), towards the axis.
///
/// @param radius, depth, poisson  as in hertz_stress(), nu of the body whose
///                                E* is that of the contact: the sphere is
///                                rigid
/// @throws std::domain_error      as hertz_stress()
/// @par Accuracy  roundoff
/// @see  K. L. Johnson, Contact Mechanics (1985), Sec. 3.4 for the surface
AxisymmetricDisplacement hertz_displacement_field(const HertzContact& contact,
                                                  double radius, double depth,
                                                  double poisson);

} // namespace asperity::theory
