#pragma once

// Measures slopes and curvatures of a height map by finite differences over one
// distance or over a range of distances.

#include "surfaces/maps/height_map.hpp"

#include <vector>

namespace asperity::surfaces {

/// Mean squares of the differences of a map over lag_x columns and lag_y rows,
///
///     slope      (h(x + d) - h(x))/d               forward difference
///     second     (h(x + d) - 2 h(x) + h(x - d))/d^2
///     laplacian  second_x + second_y at the same node
///
/// each over all nodes at which it is defined.
struct LocalDifferences {
  double distance_x = 0.0;            ///< d along x [m] > 0
  double distance_y = 0.0;            ///< d along y [m] > 0
  double mean_square_slope_x = 0.0;   ///< [1]
  double mean_square_slope_y = 0.0;   ///< [1]
  double mean_square_second_x = 0.0;  ///< [1/m^2]
  double mean_square_second_y = 0.0;  ///< [1/m^2]
  double mean_square_laplacian = 0.0; ///< [1/m^2]
  double lowest_second = 0.0; ///< smallest second difference of both directions
                              ///< [1/m]: minus the curvature of the sharpest
                              ///< peak

  /// Rms slope of both directions together [1].
  double rms_slope() const;

  /// Rms value of half the Laplacian [1/m].
  double rms_curvature() const;

  /// The larger distance [m].
  double distance() const;
};

/// Computes the differences over one pair of lags.
/// @param lag_x, lag_y  >= 1; 2 lag + 1 must not exceed the points of the side
///                      unless the map is periodic, where lag < points
/// @param is_periodic   whether differences continue across the edges; without
///                      this only differences inside the map count
/// @throws std::domain_error  a lag is outside its range
LocalDifferences local_differences(const HeightMap& map, int lag_x, int lag_y,
                                   bool is_periodic);

/// Computes the differences over distances from the larger spacing to a quarter
/// of the shorter side, some ten per decade. Where the spacings differ, the
/// distance is a multiple of the larger one and the nearest multiple of the
/// smaller one, so that it is nearly the same in both directions; differences
/// of neighbours are those of local_differences() with lags of 1.
/// @return  ascending distances; empty if a side has fewer than 4 points, or
///          the larger spacing is above a quarter of the shorter side
std::vector<LocalDifferences> scale_dependence(const HeightMap& map,
                                               bool is_periodic);

/// Nayak's parameter alpha = m_0 m_4/m_2^2 [1] >= 1 for isotropic surfaces; it
/// is 3/2 for a single wavelength with random directions and grows with the
/// width of the spectrum.
///
///     m_0 = <h^2>, m_2 = <h_x^2> = <h_y^2>, m_4 = <h_xx^2> = <h_yy^2>
///
/// are the moments along lines; those of both directions are averaged.
/// @param mean_square_height  m_0 [m^2]
/// @return  NaN for a flat map
/// @see  P. R. Nayak, J. Lubr. Technol. 93, 398 (1971)
double nayak_parameter(double mean_square_height,
                       const LocalDifferences& differences);

} // namespace asperity::surfaces
