#pragma once

// Combines the spectra of several maps of one surface, measured at different
// magnifications, each within its reliable range.

#include "surfaces/analysis/spectrum_estimate.hpp"

#include <string>
#include <utility>
#include <vector>

namespace asperity::surfaces {

/// The part of a map's spectrum that may be used.
struct SpectrumPart {
  std::vector<SpectrumRing> rings; ///< of the whole map, ascending
  double low = 0.0;                ///< reliable range [rad/m]
  double high = 0.0;               ///< [rad/m]
};

/// One spectrum from several.
struct StitchedSpectrum {
  std::vector<SpectrumRing> rows; ///< ten per decade, ascending
  /// For each part: the mean of its C over that of all parts, in the rows that
  /// it shares with others; NaN if it shares none.
  std::vector<double> ratios;
  /// Ranges of q [rad/m] between reliable ranges that no part covers.
  std::vector<std::pair<double, double>> gaps;
};

/// Averages ln C of all rings in each of ten steps per decade, weighted by
/// their degrees of freedom nu,
///
///     ln C = sum nu (ln C_ring - b(nu)) / sum nu,  b = psi(nu/2) - ln(nu/2)
///
/// where b is the mean of the logarithm of a chi-squared variable over its
/// degrees of freedom. Only rings in the reliable range of their part count.
/// @throws std::domain_error  no part has a ring in its reliable range
StitchedSpectrum stitch(const std::vector<SpectrumPart>& parts);

/// The rows as the text that `kind = "spectrum"` reads, q [1/m] and C [m^4],
/// below comment lines.
/// @param comments  lines without the leading '#'
std::string spectrum_table(const std::vector<SpectrumRing>& rows,
                           const std::vector<std::string>& comments);

} // namespace asperity::surfaces
