#pragma once

// What the report of `asperity surface` shows: analyses of maps and lines, and
// the contact that theory predicts for one of them.

#include "surfaces/analysis/surface_analysis.hpp"

#include <optional>
#include <string>
#include <vector>

namespace asperity::reports {

/// One load of the theory.
struct PredictedLoad {
  double nominal_pressure = 0.0; ///< p [Pa]
  double mean_gap = 0.0;         ///< u [m]
  double area_fraction = 0.0;    ///< A/A_0 [1]
};

/// The contact of a map without the waves that are shorter than a cut-off.
struct CutOffArea {
  double wavelength = 0.0; ///< of the cut-off [m]
  double light = 0.0;      ///< A/A_0 at light_load [1]
  double heavy = 0.0;      ///< A/A_0 at heavy_load [1]
};

/// Persson's theory for the measured spectrum.
struct PredictedContact {
  double contact_modulus = 0.0; ///< E* [Pa]
  double gamma = 0.0;           ///< of Eq. (10) of Yang and Persson (2008) [1]
  double rms_height = 0.0;      ///< of the spectrum that was used [m]
  double rms_slope = 0.0;       ///< of the same spectrum [1]
  double wavevector_low = 0.0;  ///< its range [rad/m]
  double wavevector_high = 0.0;
  double decay_length = 0.0;       ///< u_0 of Eq. (18) [m]
  double pressure_prefactor = 0.0; ///< beta of Eq. (19) [1]
  std::vector<PredictedLoad> loads;
  double light_load = 0.0; ///< 0.01 E* h' [Pa]
  double heavy_load = 0.0; ///< 0.1 E* h' [Pa]
  /// Of a map: from its longest wave to its shortest, also beyond the
  /// reliable range, which ends at wavevector_high.
  std::vector<CutOffArea> cut_offs;
};

struct SurfaceReport {
  std::string title;
  std::vector<surfaces::MapAnalysis> maps;
  std::vector<surfaces::LineAnalysis> lines;
  std::optional<PredictedContact> contact;

  std::size_t parts() const { return maps.size() + lines.size(); }

  /// Name of a part in the order maps, lines.
  const std::string& name_of(std::size_t part) const {
    return part < maps.size() ? maps[part].name
                              : lines[part - maps.size()].name;
  }
};

/// @throws input::InputError  no map or line has a wave in its reliable range;
///                            the message names each and says what would help
void require_reliable(const SurfaceReport& report);

/// Evaluates the theory for the only map or line of the report at 31 loads
/// between 1e-4 and 1 E* h'. A map enters with all rings up to the end of its
/// reliable range, so that its long waves count, and the area against the
/// cut-off is computed; a line with its reliable rows, interpolated between
/// them.
/// @param contact_modulus  E* [Pa] > 0
/// @param gamma            0 < gamma <= 1
/// @throws std::domain_error  an argument is outside its range
void add_contact(SurfaceReport& report, double contact_modulus, double gamma);

} // namespace asperity::reports
