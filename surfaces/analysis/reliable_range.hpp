#pragma once

// Determines between which wavevectors a measured spectrum is reliable: size of
// the scan, sampling, radius of the tip, noise floor.

#include "surfaces/analysis/local_differences.hpp"
#include "surfaces/analysis/spectrum_estimate.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity::surfaces {

/// White noise of the instrument, seen as a flat end of the spectrum.
struct NoiseFloor {
  double density = 0.0;    ///< C of the floor [m^4]
  double wavevector = 0.0; ///< q above which C stays below twice the floor
                           ///< [rad/m]
};

/// Finds the noise floor. The spectrum ends flat if the power law fitted to the
/// highest octave has an exponent above -1, where a self-affine surface has
/// -2 - 2 H < -2. The floor is the mean of that octave; it counts only if the
/// spectrum rises to at least 10 times its value.
/// @param rings  complete rings, ascending
std::optional<NoiseFloor> noise_floor(const std::vector<SpectrumRing>& rings);

/// Stencil length [m] below which the tip has shaped the map. A tip of radius R
/// cannot trace peaks sharper than itself; the map is unreliable at distances d
/// at which the sharpest peak, the minimum over the map of the second
/// difference D(d) in both directions, satisfies
///
///     -min D(d) > 1/(2 R)
///
/// and the length is 2 d of the largest such distance, interpolated in
/// logarithms.
/// @param scales      ascending distances
/// @param tip_radius  R [m] > 0
/// @return  empty if no distance is affected
/// @see  A. Sanner, W. G. Nöhring, L. A. Thimons, T. D. B. Jacobs, L. Pastewka,
///       Appl. Surf. Sci. Adv. 7, 100190 (2022), with the factor 1/2; T. D. B.
///       Jacobs, T. Junge, L. Pastewka, Surf. Topogr.: Metrol. Prop. 5, 013001
///       (2017)
std::optional<double> tip_length(std::span<const LocalDifferences> scales,
                                 double tip_radius);

/// The wavevectors between which all criteria are met. If none remain, low and
/// high are equal.
struct ReliableRange {
  double low = 0.0;        ///< [rad/m]
  double high = 0.0;       ///< [rad/m]
  std::string low_reason;  ///< what limits it: "size of the scan"
  std::string high_reason; ///< "sampling", "radius of the tip", "noise floor"
  std::optional<NoiseFloor> noise;
  std::optional<double> tip_wavevector; ///< 2 pi over tip_length [rad/m]
};

/// Combines the criteria. The upper limit by sampling is pi over the larger
/// spacing.
/// @param tip_radius  [m] > 0; empty: not known
ReliableRange reliable_range(const SpectrumEstimate& spectrum,
                             std::span<const LocalDifferences> scales,
                             std::optional<double> tip_radius);

} // namespace asperity::surfaces
