#pragma once

// Curves as figures want them: reduced by their own scales, averaged over
// realisations, with a colour and a sign each.

#include "reports/analysis/summary.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// A result with its case read again and its numbers worked out.
struct ReportEntry {
  const results::Result* result = nullptr;
  const cases::Case* contact_case = nullptr;
  Summary summary;
};

/// One load step over the realisations of a method: mean, least, largest.
struct SeriesRow {
  double pressure = 0.0;       ///< p/E* [1]
  double pressure_slope = 0.0; ///< p/(E* h') [1]
  double gap = 0.0;            ///< u/h_rms [1]
  double gap_low = 0.0;        ///< least of the realisations
  double gap_high = 0.0;       ///< largest
  double area = 0.0;           ///< counted [1]
  double area_low = 0.0;
  double area_high = 0.0;
  double area_corrected = 0.0;      ///< [1]
  double area_fit = 0.0;            ///< (21) of the fit [1]; NaN: none
  double theory_gap = not_a_number; ///< u/h_rms of the reference theory
  double theory_area = 0.0; ///< A/A_0 of the reference theory; NaN: none
  double iterations = 0.0;  ///< mean [1]
  double cpu_time = 0.0;    ///< mean [s]
};

struct Series {
  std::string label;     ///< method, with the case in front if there are more
  std::string legend;    ///< the label, and those of the variants it stands for
  bool is_drawn = true;  ///< false: a variant that would lie on its method
  std::string kind;      ///< of the method
  std::size_t entry = 0; ///< index of the result it belongs to
  std::size_t color = 0; ///< index among the numerical methods
  const MethodSummary* method = nullptr;
  std::vector<SeriesRow> rows; ///< in the order of the program, converged

  bool is_theory() const { return kind == "theory"; }
};

/// All methods of all results, theory first. A variant, "fem.hard", that has a
/// row for each of its "fem" with u within 0.2 % of h_rms, p within 0.5 % and
/// both areas within 1 % is not drawn: its "fem" stands for it in the legend.
std::vector<Series> series_of(std::span<const ReportEntry> entries);

/// Black for theory, else the colour of the method.
const char* series_color(const Series& series);

/// "set linetype"-like fragments for one series: colour, dash, sign.
std::string line_style(const Series& series);
std::string point_style(const Series& series);

} // namespace asperity::reports
