#pragma once

// The load of a result that the sentence of a study tells.

#include "reports/pages/html_report.hpp"
#include "results/types/curve_columns.hpp"

#include <string>

namespace asperity::studies {

/// A method and the heaviest load at which all of its realisations have a
/// number in a column; null if no method has one.
struct AnsweredLoad {
  const results::MethodRecord* method = nullptr;
  int step = 0;
  double pressure = 0.0; ///< nominal [Pa]

  /// The median of a column over the realisations at this load.
  double median(const results::CurveColumn& column) const;

  /// "at 2.3 MPa", "median of 5 realisations" if there are several, and
  /// "(halfspace)" if several methods were computed.
  std::string place(const reports::ReportEntry& entry) const;
};

/// The answer of the first method with one, theories last.
AnsweredLoad answered_load(const reports::ReportEntry& entry,
                           const results::CurveColumn& column);

} // namespace asperity::studies
