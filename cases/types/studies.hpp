#pragma once

// What a case asks of the theory besides its curve: the contact seen at
// magnifications (Sec. 8), and adhesion (Sec. 9). Plain data, part of a Case.

#include "cases/types/quantity.hpp"

#include <optional>
#include <vector>

namespace asperity::cases {

/// [magnification.leak]: what is sealed in.
struct LeakStudy {
  double density = 0.0;                ///< [kg/m^3] >= 0
  double viscosity = 0.0;              ///< [Pa s] > 0
  double pressure_drop = 0.0;          ///< [Pa] >= 0
  std::optional<double> critical_area; ///< A/A_0 [1], 0..1, ends excluded
};

/// [magnification]: A(zeta), u(zeta), u_1(zeta) under each pressure.
struct MagnificationStudy {
  std::vector<Quantity> nominal_pressures; ///< [Pa] > 0
  double from = 0.0;                       ///< lowest zeta [1] > 0
  double to = 0.0;                         ///< highest zeta > from
  int points = 0;                          ///< magnifications, both ends in
  double reference_wavevector = 0.0;       ///< q_ref = q/zeta [rad/m] > 0
  std::optional<LeakStudy> leak;
};

/// [adhesion]: gamma_eff at ratios h_rms/h_rms0, h_rms0 that of the case.
struct AdhesionStudy {
  double work_of_adhesion = 0.0;           ///< Dgamma [J/m^2] > 0
  double from = 0.0;                       ///< lowest ratio [1] > 0
  double to = 0.0;                         ///< highest ratio > from
  int points = 0;                          ///< ratios, both ends in
  std::optional<double> detachment_factor; ///< c; none: 2/pi of theory/
  std::optional<double> sphere_radius; ///< R [m] > 0, for the pull-off force
  int steps = 0;                       ///< of the discretisation of ln q
};

} // namespace asperity::cases
