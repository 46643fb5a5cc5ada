#pragma once

// How far the methods of several results agree: each method, of whatever
// program, beside one reference method, in numbers and fields.

#include "reports/figures/series.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// One load of one method beside the reference at the same nominal pressure.
struct AgreementRow {
  int realization = 0;
  double nominal_pressure = 0.0;             ///< [Pa]
  double gap_difference = not_a_number;      ///< (u - u_ref)/h_rms [1]
  double area_difference = not_a_number;     ///< A/A_ref - 1, as counted [1]
  double pressure_difference = not_a_number; ///< of the saved fields: rms(p -
                                             ///< p_ref)/rms(p_ref) [1]
  double certified_error = not_a_number;     ///< bound of u's error [h_rms]
  double estimated_error = not_a_number;     ///< estimate of it [h_rms]
};

/// A method beside the reference method.
struct Agreement {
  std::string method;    ///< with its case if there are several
  std::string reference; ///< likewise
  std::string problem;   ///< why nothing can be compared; empty: rows follow
  std::vector<AgreementRow> rows;

  /// The largest size of a number over all rows; NaN if no row has it.
  double largest(double AgreementRow::*number) const;
};

/// Compares every method that is no theory with the first such method of the
/// first result, realisation by realisation. Curves are interpolated in the
/// load and not extrapolated; fields are compared if both are saved at one load
/// (to 1e-6) on one grid. Surfaces must have the same E* and rms height to
/// 1e-6. Empty if there is only one such method.
std::vector<Agreement> agreements_of(std::span<const ReportEntry> entries,
                                     std::span<const Series> series);

/// The rows as JSON, and as CSV with one line per row.
nlohmann::ordered_json agreement_json(std::span<const Agreement> agreements);
std::string agreement_csv(std::span<const Agreement> agreements);

} // namespace asperity::reports
