#pragma once

// Combines the analyses of one map or one line scan into a record that a page,
// a table or a script can show.

#include "surfaces/analysis/height_parameters.hpp"
#include "surfaces/analysis/line_scan.hpp"
#include "surfaces/analysis/local_differences.hpp"
#include "surfaces/analysis/reliable_range.hpp"
#include "surfaces/analysis/self_affine_fit.hpp"
#include "surfaces/analysis/spectrum_estimate.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::surfaces {

/// Everything that is computed of one map.
struct MapAnalysis {
  std::string name;   ///< of the file or case, for tables
  std::string origin; ///< how it was read and levelled, a sentence
  std::vector<std::string> warnings; ///< of its reader, one line each
  HeightMap map;
  bool is_periodic = false;
  HeightParameters heights;
  LocalDifferences neighbours;          ///< over one spacing of each side
  std::vector<LocalDifferences> scales; ///< over longer distances, may be empty
  double nayak = 0.0;                   ///< by neighbours [1]
  SpectrumEstimate spectrum;
  ReliableRange range;
  std::optional<SelfAffineFit> fit; ///< empty: too few rings
};

/// Analyses a map.
/// @param map         levelled, at least 4 points per side
/// @param tip_radius  of the instrument [m] > 0; empty: not known
/// @throws std::domain_error  the map is flat or too small
MapAnalysis analyse_map(HeightMap map, bool is_periodic,
                        std::optional<double> tip_radius);

/// Everything that is computed of one line scan.
struct LineAnalysis {
  std::string name;
  std::string origin;
  LineScan line;
  ProfileParameters profile;
  std::vector<SpectrumRing> line_rows; ///< C_1 [m^3], eight per decade
  std::vector<SpectrumRing> rows;      ///< C [m^4] of the isotropic surface
  double low = 0.0;  ///< reliable range [rad/m]: twice the lowest wavevector
  double high = 0.0; ///< to half of that of the sampling, because the
                     ///< conversion continues C_1 beyond its end
};

/// Analyses a levelled line.
/// @throws std::domain_error  the line is flat
LineAnalysis analyse_line(LineScan line);

/// C(q) in the reliable range of a map, ten rows per decade, or of a line;
/// empty if nothing is reliable.
std::vector<SpectrumRing> reliable_rows(const MapAnalysis& analysis);
std::vector<SpectrumRing> reliable_rows(const LineAnalysis& analysis);

} // namespace asperity::surfaces
