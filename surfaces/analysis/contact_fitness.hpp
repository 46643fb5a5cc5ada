#pragma once

// Whether a map is good enough for a question of contact: its noise, its
// points and its size, each as one number with a limit.

#include "surfaces/analysis/spectrum_estimate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::surfaces {

/// What the spectrum of a map says of it.
struct ContactFitness {
  /// Share of <|grad h|^2> beyond the noise floor [1]; 0 without a floor.
  double noise_share = 0.0;
  /// Points of the wave beyond which 60 % of <|grad h|^2> lies [1].
  double points_per_wave = 0.0;
  /// Waves per side of the wave up to which half of <h^2> lies [1].
  double waves_per_scan = 0.0;

  static constexpr double most_noise = 0.2;
  static constexpr double least_points = 4.0;
  /// About 25 independent waves, so that h_rms differs by about 10 % from place
  /// to place.
  static constexpr double least_waves = 4.0;

  /// Slope, and with it area and stiffness, are those of the surface.
  bool serves_area() const {
    return noise_share <= most_noise && points_per_wave >= least_points;
  }

  /// h_rms, and with it the mean gap, are those of any place.
  bool serves_gap() const { return waves_per_scan >= least_waves; }
};

/// @param rings    of the whole spectrum, ascending
/// @param noise    wavevector beyond which there is noise [rad/m]; empty: none
/// @param spacing  the larger one [m]
/// @param side     the shorter one [m]
ContactFitness contact_fitness(const std::vector<SpectrumRing>& rings,
                               std::optional<double> noise, double spacing,
                               double side);

/// "The map is good enough for the contact area, but not for the mean gap of
/// other places (noise has 0 % of the slope; 6.3 points per steep wave; 1.2
/// high waves per scan, and 4 are needed)."
std::string fitness_sentence(const ContactFitness& fitness);

} // namespace asperity::surfaces
