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

/// Finds the noise floor N. Over the two highest octaves, C = A q^-s + N with 2
/// <= s <= 4.5 must be more likely than every power law with s >= 2, as
/// self-affine surfaces have, by 12 in the deviance over the dispersion of the
/// rings, and N more than half of C at their end. The spectrum must rise to at
/// least 10 times N.
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
  std::string high_reason; ///< "sampling", "radius of the tip", "noise floor",
                           ///< "noise between scans"
  std::optional<NoiseFloor> noise;
  std::optional<double> tip_wavevector; ///< 2 pi over tip_length [rad/m]
};

/// Combines the criteria. The upper limit by sampling is pi over the larger
/// spacing.
/// @param tip_radius  [m] > 0; empty: not known
ReliableRange reliable_range(const SpectrumEstimate& spectrum,
                             std::span<const LocalDifferences> scales,
                             std::optional<double> tip_radius);

/// Limits the range by another scan of the same place. Two scans that share the
/// surface and not their noise differ by twice the noise: C >= 2 N holds where
/// C of the scan exceeds that of the difference. Shifts between the scans count
/// as noise. Nothing changes if the maps have different grids, are equal, or
/// have a correlation below 0.7, as two places of one surface have.
/// @param scan, repeat  levelled, with mean 0
void limit_by_repeat(ReliableRange& range, const HeightMap& scan,
                     const HeightMap& repeat, bool is_periodic);

} // namespace asperity::surfaces
