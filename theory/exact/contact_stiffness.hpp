#pragma once

// Has the incremental stiffness of a circular contact, on a half-space and in a
// square array on a block of finite thickness.

namespace asperity::theory {

/// Force per further displacement of the rigid body that makes the contact.
struct StiffnessPair {
  double normal = 0.0;     ///< along the normal, without friction [N/m]
  double tangential = 0.0; ///< laterally, the whole contact sticks [N/m]
};

/// The stiffness of a contact on a half-space,
///
///     k_n = 2 E* a,    k_t = 8 a G/(2 - nu),
///
/// of one elastic body on a rigid one, G = E* (1 - nu)/2.
/// @param radius           a [m] > 0
/// @param contact_modulus  E* [Pa] > 0
/// @param poisson          nu [1], -1 to 1/2
/// @throws std::domain_error  an argument is outside its range or not finite
/// @see  R. D. Mindlin, J. Appl. Mech. 16, 259 (1949), which neglects that
///       lateral forces also displace the surface along its normal
StiffnessPair halfspace_stiffness(double radius, double contact_modulus,
                                  double poisson);

/// A square array of contacts, one on each square of side L, on a block of
/// thickness H that is clamped at its back.
struct ContactArray {
  double side = 0.0;            ///< L [m] > 0
  double depth = 0.0;           ///< H [m] > 0
  double contact_modulus = 0.0; ///< E* [Pa] > 0
  double poisson = 0.0;         ///< nu [1], -1 < nu < 1/2
};

/// The stiffness that the contact would have alone on a half-space: its
/// compliance in the array without the uniform strain of the block and with
/// what the other contacts displace it,
///
///     1/k_n(alone) = 1/k_n - H (1 - 2 nu)/(2 G (1 - nu) L^2)
///                          + S (1 - nu)/(2 pi G L),
///     1/k_t(alone) = 1/k_t - H/(G L^2) + S (2 - nu)/(4 pi G L),
///
/// where S is square_array_constant() of hertz.hpp.
/// @param in_array  both > 0
/// @throws std::domain_error  an argument is outside its range or not finite
/// @par Accuracy  (a/L)^3, and exp(-2 pi H/L) by the back of the block
StiffnessPair stiffness_alone(const StiffnessPair& in_array,
                              const ContactArray& array);

} // namespace asperity::theory
