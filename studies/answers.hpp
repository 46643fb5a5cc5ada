#pragma once

// The row of a result that the sentence of a study tells.

#include "reports/pages/html_report.hpp"
#include "results/types/curve_columns.hpp"

#include <string>

namespace asperity::studies {

/// A method and the row of its first realisation with the heaviest load at
/// which a column has a number; both null if none has.
struct AnsweredRow {
  const results::MethodRecord* method = nullptr;
  const results::CurvePoint* row = nullptr;

  /// "at 2.3 MPa", and "(halfspace)" if several methods were computed.
  std::string place(const reports::ReportEntry& entry) const;
};

/// The answer of the first method with one, theories last.
AnsweredRow answered_row(const reports::ReportEntry& entry,
                         const results::CurveColumn& column);

} // namespace asperity::studies
