#pragma once

// The stiffness of a contact whose nodes stay in contact: that of a rigid punch
// which is bonded to them along the normal.

#include "contact/operators/surface_operator.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace asperity::contact {

struct PunchStiffness {
  /// K = -dp_0/d(mean gap) [Pa/m]: the change of the mean pressure per approach
  /// of the punch. Infinite if all nodes of a periodic surface are in hard
  /// contact, 0 without contact.
  double stiffness = 0.0;
  int iterations = 0;
  bool converged = false;
  std::vector<double> pressure = {}; ///< q, if it was solved for
};

/// Solves for the change of pressure q, of mean 1, on the nodes in contact
///
///     (C + c) q = 1/K  there,   q = 0 elsewhere,
///
/// by preconditioned conjugate gradients in double precision. q has no sign: it
/// is the change of the pressure in a small further approach, in which no node
/// comes into contact or leaves it. K is <q>^2/<q (C + c) q>, which a wrong q
/// only makes too small, and whose error is of second order in that of q.
///
/// By Barber's analogy of elasticity and conduction, the contact of two bodies
/// with the resistivities rho_1 and rho_2 has the conductance
/// 2 K/(E* (rho_1 + rho_2)) per nominal area: J. R. Barber, Proc. R. Soc. A
/// 459, 53 (2003).
///
/// With a film, q acts on all nodes, and c of those not in contact is that of
/// the film there. By the analogy, a medium of the conductivity k_g in a gap u
/// passes heat beside the spots: c = u k/(k_g E*), k = 2/(rho_1 + rho_2).
///
/// @param is_in_contact     n_nodes() values, 0: not in contact
/// @param local_compliance  c [m/Pa] >= 0
/// @param film              as many values [m/Pa] > 0, of which those in
/// contact
///                          are not used; empty: no film
/// @throws std::domain_error  a size is wrong
/// @par Accuracy  1e-9 of K for the discrete problem; that of the border of the
///                contact, first order in the spacing. Bitwise the same on any
///                number of threads and ranks.
PunchStiffness punch_stiffness(SurfaceOperator& elasticity,
                               std::span<const std::uint8_t> is_in_contact,
                               double local_compliance = 0.0,
                               std::span<const double> film = {});

/// What a film adds to the stiffness of hard contact.
struct FilmStiffness {
  /// K with the film less K_s without it [Pa/m] >= 0. Infinite if all nodes of
  /// a periodic surface are in contact.
  double stiffness = 0.0;
  bool converged = false;
};

/// Solves for the change of pressure v, of mean 0, by which the film lowers the
/// energy 1/K_s of the contact alone, whose pressure is q_s:
///
///     (C + c) v = r + const,   r = 0 in contact,  1/K_s - C q_s elsewhere,
///
/// with c = 0 in contact. The gain in energy <v (C + c) v> is the sum of those
/// of the iterations, all of which are positive, so that a film that adds a
/// millionth of a millionth is as accurate as one that adds a tenth.
///
/// @param film  as in punch_stiffness(), not empty
/// @throws std::domain_error  a size is wrong
/// @par Accuracy  1e-7 of the result. Bitwise the same on any number of threads
///                and ranks.
FilmStiffness film_stiffness(SurfaceOperator& elasticity,
                             std::span<const std::uint8_t> is_in_contact,
                             std::span<const double> film);

} // namespace asperity::contact
