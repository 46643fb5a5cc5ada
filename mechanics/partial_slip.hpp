#pragma once

// Partial slip of a rough contact under a normal and a growing tangential load,
// from normal contact alone (Ciavarella 1998; Jaeger 1998): with friction mu
// and the constant normal load P, the traction under the tangential load Q is
//
//     q = mu [p(P) - p(P')],   P' = P - Q/mu,
//
// in the direction of Q. Nodes in contact at P' stick, the others of the
// contact at P slip. It holds if normal and tangential tractions do not couple
// and the tangential compliance is kappa times the normal one.

#include "mechanics/material.hpp"

namespace asperity::mechanics {

/// kappa = sum c_i (2 - nu_i)/(2 - 2 nu_i) / sum c_i over the elastic bodies,
/// c_i = (1 - nu_i^2)/E_i: the tangential compliance over the normal one
/// (Mindlin 1949), which is the mean over the directions of the surface
/// [1] >= 0.75.
/// @throws std::domain_error  Poisson's ratio of the block is not known
double tangential_ratio(const MaterialSpec& material);

/// Dundurs' beta of the pair, by which normal and tangential tractions couple:
/// 0 for equal bodies and for an incompressible body on a rigid one [1].
/// @throws std::domain_error  Poisson's ratio of the block is not known
double coupling(const MaterialSpec& material);

/// A normal contact without friction.
struct NormalContact {
  double pressure = 0.0;       ///< nominal, p_0 [Pa] > 0
  double approach = 0.0;       ///< of far points, from any origin [m]
  double area_fraction = 0.0;  ///< A/A_0 [1]
  double elastic_energy = 0.0; ///< per nominal area [J/m^2]
};

/// The surface between the bodies, and how the bodies give way.
struct Friction {
  double coefficient = 0.0; ///< mu [1] > 0
  double ratio = 1.0;       ///< kappa, tangential_ratio()
};

struct PartialSlip {
  double tangential_stress = 0.0; ///< Q over the nominal area [Pa]
  double displacement = 0.0;      ///< of far points along Q [m]
  double stick_area = 0.0;        ///< over the nominal area [1]
  double slip_area = 0.0;         ///< likewise [1]
  /// Energy lost in a cycle between Q and -Q, per nominal area [J/m^2]: by
  /// Masing's rule 4 mu^2 kappa [(P + P') D - 2 (U - U')] with the difference D
  /// of both approaches and the elastic energies U of both normal contacts.
  double loss = 0.0;
};

/// Returns the contact at the normal load of `pressed` and the tangential load
/// mu (P - P'), with P' that of `eased`.
/// @param eased  the same contact at a load 0 < P' <= P
/// @see  M. Ciavarella, J. Appl. Mech. 65, 998 (1998);
///       J. Jaeger, J. Tribol. 120, 677 (1998); docs/numerics/friction.md
PartialSlip partial_slip(const NormalContact& pressed,
                         const NormalContact& eased, const Friction& friction);

} // namespace asperity::mechanics
