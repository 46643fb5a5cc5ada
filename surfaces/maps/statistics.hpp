#pragma once

// The statistics of a height map: moments of the heights, spectral slope and
// curvature, height distribution.

#include "surfaces/maps/height_map.hpp"

#include <span>

namespace asperity::surfaces {

/// Averages of heights above their mean.
struct HeightMoments {
  double mean = 0.0;           ///< [m]
  double mean_magnitude = 0.0; ///< <|h|> [m]
  double rms = 0.0;            ///< sqrt <h^2> [m]
  double skewness = 0.0;       ///< <h^3>/<h^2>^(3/2) [1], NaN if all are equal
  double kurtosis = 0.0;       ///< <h^4>/<h^2>^2 [1], NaN if all are equal
  double highest = 0.0;        ///< max h - <h> [m]
  double lowest = 0.0;         ///< min h - <h> [m]
};

HeightMoments moments_of(std::span<const double> heights);

/// Averages over the nodes, with <h> subtracted; a_q are the Fourier
/// coefficients of the map (mode_power.hpp explains how Nyquist modes are
/// counted):
///
///     rms_height     sqrt <h^2>
///     rms_slope      sqrt sum q^2 |a_q|^2      of grad h, both directions
///     rms_curvature  sqrt(sum q^4 |a_q|^2)/2   of half the Laplacian, the mean
///                                              of the principal curvatures
///     skewness       <h^3>/<h^2>^(3/2), kurtosis <h^4>/<h^2>^2 (3: Gaussian)
struct Statistics {
  double rms_height = 0.0;    ///< h_rms [m]
  double rms_slope = 0.0;     ///< [1]
  double rms_curvature = 0.0; ///< [1/m]
  double skewness = 0.0;      ///< [1], NaN for a flat map
  double kurtosis = 0.0;      ///< [1], NaN for a flat map
  double highest = 0.0;       ///< max h - <h> [m]
  double lowest = 0.0;        ///< min h - <h> [m]
};

Statistics statistics(const HeightMap& map);

} // namespace asperity::surfaces
