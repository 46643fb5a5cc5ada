#pragma once

// Prepares curves for plotting: they are normalised, averaged over
// realisations, and have a colour and a marker each. "Eq. (21)" is that of Yang
// and Persson (2008).

#include "reports/analysis/summary.hpp"
#include "reports/explore/chart.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// A result with its parsed case and its evaluated summary.
struct ReportEntry {
  const results::Result* result = nullptr;
  const cases::Case* contact_case = nullptr;
  Summary summary;
};

/// One load step over the realisations of a method: mean, minimum and maximum.
/// Realisations without contact are included, and a step that one of them has
/// not reached has no row: the others alone would be another surface.
struct SeriesRow {
  double pressure = 0.0;               ///< p/E* [1]
  double pressure_slope = 0.0;         ///< p/(E* h') [1]
  double gap = 0.0;                    ///< u/h_rms [1]
  double gap_low = 0.0;                ///< minimum over the realisations
  double gap_high = 0.0;               ///< maximum over the realisations
  double gap_interval = not_a_number;  ///< half-width of the 95 % interval of
                                       ///< the mean; NaN: one realisation
  double area = 0.0;                   ///< counted [1]
  double area_corrected = 0.0;         ///< best estimate: corrected, or else
                                       ///< counted [1]
  double area_interval = not_a_number; ///< as gap_interval, of area_corrected
  double area_fit = 0.0;               ///< Eq. (21) of the fit [1]; NaN: none
  double theory_gap = not_a_number;    ///< u/h_rms of the reference theory
  double theory_area = 0.0; ///< A/A_0 of the reference theory; NaN: none
  double iterations = 0.0;  ///< mean [1]
  double cpu_time = 0.0;    ///< mean [s]
};

struct Series {
  std::string label;     ///< method, preceded by the case if there are several
  std::string legend;    ///< the label, and those of the variants it represents
  bool is_drawn = true;  ///< false: variant represented by its base method
  std::string kind;      ///< of the method
  std::size_t entry = 0; ///< index of the result it belongs to
  std::size_t color = 0; ///< index among the numerical methods
  const MethodSummary* method = nullptr;
  std::vector<SeriesRow> rows; ///< converged and pressed, in the order of the
                               ///< loading path
  /// Of a theory: its curve between these loads, with gap and areas.
  std::vector<SeriesRow> fine = {};

  bool is_theory() const { return kind == "theory"; }

  /// The rows of a curve that is drawn as a line.
  const std::vector<SeriesRow>& line_rows() const {
    return fine.empty() ? rows : fine;
  }
};

/// Returns all methods of all results, theory first. A variant such as
/// "fem.hard" is not drawn if it has a row for each row of its base method
/// "fem" with u within 0.2 % of h_rms, p within 0.5 % and both areas within 1
/// %; the base method then represents it in the legend.
std::vector<Series> series_of(std::span<const ReportEntry> entries);

/// Returns black for a theory, otherwise the colour of the method.
const char* series_color(const Series& series);

/// Return how the line and the markers of one series are drawn.
CurveStyle line_style(const Series& series);
CurveStyle point_style(const Series& series);

} // namespace asperity::reports
