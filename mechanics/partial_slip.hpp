#pragma once

// Partial slip of a rough contact under a normal and a growing tangential load,
// from normal contact alone (Ciavarella 1998; Jaeger 1998): with friction mu
// and the constant normal load P, the traction under the tangential load Q is
//
//     q = mu [p(P) - p(P')],   P' = P - Q/mu,
//
// in the direction of Q. Nodes in contact at P' stick, the others of the
// contact at P slip. The traction is that of Coulomb's law if normal and
// tangential tractions do not couple and the tangential compliance is kappa
// times the normal one. A half-space has a kappa of each direction of a wave:
// 1 of those whose wavevector is along Q, more of those across it. So each
// contact has its own, and the displacement follows from those of all contacts
// between P' and P.

#include "mechanics/material.hpp"

#include <span>

namespace asperity::mechanics {

/// kappa = sum c_i (2 - nu_i)/(2 - 2 nu_i) / sum c_i over the elastic bodies,
/// c_i = (1 - nu_i^2)/E_i: the tangential compliance over the normal one
/// (Mindlin 1949), which is the mean over the directions of the surface
/// [1] >= 0.75.
/// @throws std::domain_error  Poisson's ratio of the block is not known
double tangential_ratio(const MaterialSpec& material);

/// B = sum c_i nu_i/(1 - nu_i) / sum c_i: the tangential compliance of waves
/// whose wavevector has the angle a with Q is kappa + B/2 - B cos^2 a times
/// their normal one [1], that is 1 for a = 0.
/// @throws std::domain_error  Poisson's ratio of the block is not known
double tangential_anisotropy(const MaterialSpec& material);

/// Dundurs' beta of the pair, by which normal and tangential tractions couple:
/// 0 for equal bodies and for an incompressible body on a rigid one [1].
/// @throws std::domain_error  Poisson's ratio of the block is not known
double coupling(const MaterialSpec& material);

/// Along x and along y.
struct Directions {
  double x = 0.0, y = 0.0;
};

/// A normal contact without friction.
struct NormalContact {
  double pressure = 0.0;       ///< nominal, p_0 [Pa] > 0
  double approach = 0.0;       ///< of far points, from any origin [m]
  double area_fraction = 0.0;  ///< A/A_0 [1]
  double elastic_energy = 0.0; ///< per nominal area [J/m^2]
  /// kappa: tangential over normal compliance, if all of it sticks [1].
  Directions ratio = {1.0, 1.0};
};

struct PartialSlip {
  double tangential_stress = 0.0; ///< Q over the nominal area [Pa]
  Directions displacement;        ///< of far points, under Q along x, y [m]
  double stick_area = 0.0;        ///< over the nominal area [1]
  double slip_area = 0.0;         ///< likewise [1]
  /// Energy lost in a cycle between Q and -Q, per nominal area [J/m^2]: by
  /// Masing's rule 8 times the integral of Q over the displacement less 4 Q
  /// times the displacement, which is 4 mu^2 kappa [(P + P') D - 2 (U - U')]
  /// for one kappa, with the difference D of both approaches and the elastic
  /// energies U of both normal contacts.
  Directions loss;
};

/// Returns the contact at the normal load P and the tangential load
/// mu (P - P'). As Q grows, the contact that sticks goes from that at P to that
/// at P', and the displacement by mu kappa dD of each.
/// @param path  the same contact at rising loads from 0 < P' to P, at least
///              one; kappa is interpolated linearly in the approach
/// @see  M. Ciavarella, J. Appl. Mech. 65, 998 (1998);
///       J. Jaeger, J. Tribol. 120, 677 (1998); docs/numerics/friction.md
PartialSlip partial_slip(std::span<const NormalContact> path,
                         double coefficient);

} // namespace asperity::mechanics
