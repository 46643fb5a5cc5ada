#pragma once

// The studies of a case besides its curve: the contact at a range of
// magnifications and adhesion by the theory (Secs. 8 and 9 of Yang and Persson,
// 2008), and, of each load step, the flow through the gap, the spots of contact
// and what they conduct, and partial slip. Plain data, part of a Case.

#include "mechanics/quantity.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace asperity::cases {

/// [magnification.leak]: the fluid and the seal.
struct LeakStudy {
  double density = 0.0;                ///< [kg/m^3] >= 0
  double viscosity = 0.0;              ///< [Pa s] > 0
  double pressure_drop = 0.0;          ///< [Pa] >= 0
  std::optional<double> critical_area; ///< critical A/A_0 [1], 0..1, ends
                                       ///< excluded
};

/// [magnification]: A(zeta), u(zeta) and u_1(zeta) for each pressure.
struct MagnificationStudy {
  std::vector<mechanics::Quantity> nominal_pressures; ///< [Pa] > 0
  double from = 0.0;                                  ///< lowest zeta [1] > 0
  double to = 0.0;                                    ///< highest zeta > from
  int points = 0; ///< number of magnifications, including both ends
  double reference_wavevector = 0.0; ///< q_ref = q/zeta [rad/m] > 0
  std::optional<LeakStudy> leak;
};

/// [adhesion]: gamma_eff at the ratios h_rms/h_rms0, where h_rms0 is the rms
/// height of the case.
struct AdhesionStudy {
  double work_of_adhesion = 0.0; ///< Dgamma [J/m^2] > 0
  double from = 0.0;             ///< lowest ratio [1] > 0
  double to = 0.0;               ///< highest ratio > from
  int points = 0;                ///< number of ratios, including both ends
  std::optional<double> detachment_factor; ///< c; none: 2/pi, the default of
                                           ///< the theory
  std::optional<double> sphere_radius; ///< R [m] > 0, for the pull-off force
  int steps = 400;                     ///< number of steps from q_L to q_1
};

/// [flow]: a fluid that a pressure drop drives through the gap.
struct FlowStudy {
  double viscosity = 0.0;       ///< eta [Pa s] > 0
  double pressure_drop = 0.0;   ///< Dp [Pa] >= 0
  std::optional<double> length; ///< of the seal, along the flow [m] > 0
  std::optional<double> width;  ///< of the seal, across the flow [m] > 0

  /// Width over length; 1 if they are not given.
  double aspect() const { return width.value_or(1.0) / length.value_or(1.0); }
};

/// [friction]: partial slip under one normal load of the case.
struct FrictionStudy {
  double coefficient = 0.0; ///< mu [1] > 0
  /// P, nominal [Pa] > 0; none: the largest load.
  std::optional<mechanics::Quantity> normal_load;
  /// Q/(mu P) [1] of tangential loads that get load steps of their own.
  std::vector<mechanics::Quantity> tangential_loads;
  /// The load steps of P and of the lighter load nearest to P/2, whose maps
  /// give that of the traction; empty unless the loads are pressures that rise.
  std::vector<std::size_t> map_steps = {};
};

/// [spots]: the clusters of contact and of the gap.
struct SpotsStudy {
  int smallest = 10; ///< nodes of the smallest cluster in a dimension >= 1
};

/// [conductance]: two bodies that exchange heat and current through the spots
/// of contact, and heat through the medium in the gap.
struct ConductanceStudy {
  /// Of the block and of the body on it.
  std::optional<double> thermal_conductivity;         ///< [W/(m K)] > 0
  std::optional<double> counter_thermal_conductivity; ///< [W/(m K)] > 0
  std::optional<double> resistivity;                  ///< [Ohm m] > 0
  std::optional<double> counter_resistivity;          ///< [Ohm m] > 0
  /// Of the medium in the gap; none: it conducts nothing. It passes heat as if
  /// the gap were at least the smallest one.
  std::optional<double> gap_conductivity; ///< [W/(m K)] > 0
  std::optional<double> smallest_gap;     ///< [m] > 0

  /// The harmonic mean of the bodies, 2 k_1 k_2/(k_1 + k_2) [W/(m K)], which
  /// must be given.
  double conductivity() const {
    return 2.0 /
           (1.0 / *thermal_conductivity + 1.0 / *counter_thermal_conductivity);
  }
};

} // namespace asperity::cases
