#pragma once

// Lists the numbers of a surface report with their names, units and meanings,
// for the table on the terminal, the page and the JSON file.

#include "reports/surface/surface_report.hpp"

#include <string>
#include <vector>

namespace asperity::reports {

/// One number of a map or line, in SI units.
struct SurfaceQuantity {
  std::string key;          ///< in the JSON file: "sq"
  std::string symbol;       ///< on the page: "Sq"
  std::string meaning;      ///< "root mean square height"
  std::string unit;         ///< "m", "1" or "1/m"
  double by_nodes = 0.0;    ///< by sums and differences over the nodes; NaN if
                            ///< it has no such value
  double by_spectrum = 0.0; ///< by the spectrum; NaN if it has no such value
};

std::vector<SurfaceQuantity> quantities_of(const surfaces::MapAnalysis& map);
std::vector<SurfaceQuantity> quantities_of(const surfaces::LineAnalysis& line);

/// One fitted parameter of the self-affine model.
struct FittedQuantity {
  std::string key; ///< "hurst"
  std::string symbol;
  std::string meaning;
  std::string unit;
  surfaces::FittedParameter parameter;
};

std::vector<FittedQuantity> quantities_of(const surfaces::SelfAffineFit& fit);

/// Returns "0.80 [0.76, 0.84]", or the reason why it is not determined.
std::string fitted_text(const FittedQuantity& quantity);

/// Returns "0.76 to 0.84", or the reason why there is no interval.
std::string interval_text(const FittedQuantity& quantity);

/// Returns "10 µm to 312 nm": the wavelengths of a range of wavevectors.
std::string wavelengths_text(double low, double high);

/// Describes the reliable range of a map or line in one sentence.
std::string range_text(const surfaces::MapAnalysis& map);
std::string range_text(const surfaces::LineAnalysis& line);

/// Whether a map is good enough for contact, and why, in one sentence.
std::string fitness_text(const surfaces::MapAnalysis& map);

} // namespace asperity::reports
