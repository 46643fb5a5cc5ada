#pragma once

// Huber's closed form of the stress below a Hertzian contact, anywhere in the
// half-space; hertz.hpp has the values on the surface and on the axis.

#include "theory/exact/hertz.hpp"

namespace asperity::theory {

/// Stress at one point of an axisymmetric state, tension positive [Pa].
struct AxisymmetricStress {
  double radial = 0.0; ///< sigma_r
  double hoop = 0.0;   ///< sigma_theta
  double axial = 0.0;  ///< sigma_z
  double shear = 0.0;  ///< tau_rz, z into the body

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

} // namespace asperity::theory
