#pragma once

// [magnification] and [magnification.leak]: their settings (Sec. 8 of Yang and
// Persson, 2008).

#include "mechanics/quantity.hpp"
#include "studies/study.hpp"

#include <optional>
#include <vector>

namespace asperity::studies {

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

/// [magnification]: the contact at a range of magnifications by the theory,
/// with the leak through the one pore at which the open area percolates (Sec. 8
/// of Yang and Persson, 2008).
extern const Study magnification_study;

/// Its pages, which its object joins.
const reports::StudyPages& magnification_pages();

} // namespace asperity::studies
