#pragma once

// Estimates the isotropic height spectrum C(q) of a measured map: the window,
// its correction, averages over rings of |q|, and their confidence.

#include "surfaces/maps/height_map.hpp"

#include <vector>

namespace asperity::surfaces {

/// The mean of C over the modes of nearly equal |q|, or a row that was made
/// from such rings.
struct SpectrumRing {
  double wavevector = 0.0;         ///< q [rad/m] > 0
  double density = 0.0;            ///< C [m^4] > 0
  double degrees_of_freedom = 0.0; ///< nu: for a Gaussian random surface
                                   ///< nu C_estimate/C is chi-squared
                                   ///< distributed [1] > 0
  double mean_square_height = 0.0; ///< its part of <h^2> [m^2]
};

/// The spectrum of one map in the normalisation of isotropic_spectrum.hpp. The
/// rings contain every mode except q = 0: the sum of their mean_square_height
/// is <h^2> of the periodic map, or of the windowed map divided by the mean
/// square of the window, to roundoff.
struct SpectrumEstimate {
  std::vector<SpectrumRing> rings; ///< ascending, some 90 per decade
  double wavevector_low = 0.0;     ///< lowest q at which the estimate can be
                                   ///< trusted [rad/m]
  double wavevector_high = 0.0;    ///< pi over the larger spacing: beyond it a
                                   ///< ring is incomplete [rad/m]
  double rms_height = 0.0;         ///< [m] root of the sum over the rings
  double rms_slope = 0.0;          ///< [1] both directions
  double rms_curvature = 0.0;      ///< of half the Laplacian [1/m]
  bool is_windowed = false;
};

/// Estimates the spectrum. A map that is not periodic is multiplied by the 2-D
/// Hann window (edges.hpp), and the power is divided by the mean square 9/64 of
/// the window. The window smooths over two modes on either side, so that
///
///     wavevector_low = 2 pi/L            periodic, L the shorter side
///                      2 (2 pi/L)        windowed
///
/// and makes neighbouring modes dependent: nu of a ring is the number of its
/// modes, q and -q both counted, divided by 3.78 = (1 + 2 (4/9 + 1/36))^2, the
/// sum of the correlations of |a_q|^2 between modes of a windowed white noise.
/// @throws std::domain_error  the map is flat
SpectrumEstimate estimate_spectrum(const HeightMap& map, bool is_periodic);

/// Rings joined to at most `per_decade` steps of ln q; C is the mean over all
/// modes and q^2 their mean, weighted by power.
std::vector<SpectrumRing> joined_rings(const std::vector<SpectrumRing>& rings,
                                       double per_decade);

/// Rings with low <= q <= high, with a relative tolerance of 1e-9.
std::vector<SpectrumRing> rings_between(const std::vector<SpectrumRing>& rings,
                                        double low, double high);

/// The 95 % confidence interval of C [m^4] of a ring, from the quantiles of the
/// chi-squared distribution.
struct DensityInterval {
  double low = 0.0;
  double high = 0.0;
};

DensityInterval confidence_of(const SpectrumRing& ring);

/// Nayak's parameter m_0 m_4/m_2^2 [1] of an isotropic surface by its spectrum:
/// m_0 = rms_height^2, m_2 = rms_slope^2/2, m_4 = (3/2) rms_curvature^2.
double nayak_parameter(const SpectrumEstimate& spectrum);

} // namespace asperity::surfaces
