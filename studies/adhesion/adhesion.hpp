#pragma once

// [adhesion]: its settings (Sec. 9 of Yang and Persson, 2008).

#include "studies/study.hpp"

#include <optional>

namespace asperity::studies {

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

/// [adhesion]: adhesion of rough faces by the theory (Sec. 9 of Yang and
/// Persson, 2008).
extern const Study adhesion_study;

/// Its pages, which its object joins.
const reports::StudyPages& adhesion_pages();

} // namespace asperity::studies
