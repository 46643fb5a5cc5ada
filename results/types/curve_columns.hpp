#pragma once

// The columns of a curve: their names, units, ranges and order. The one table
// that the HDF5 writer, its reader, its checks and the CSV file are made from.

#include "results/types/result.hpp"

#include <span>
#include <string>
#include <string_view>

namespace asperity::results {

/// What a number can be, both ends included, rounding of 1e-9 apart where an
/// end is 1. NaN, "not determined", is allowed unless is_needed.
struct ColumnRange {
  double lowest;
  double highest;
  bool is_needed = false; ///< in every step that converged

  /// "must lie between 0 and 1", "must be finite and >= 0".
  std::string text() const;

  /// True for a number within the range; NaN is none.
  bool holds(double number) const;
};

inline constexpr ColumnRange not_negative{0.0,
                                          std::numeric_limits<double>::max()};

/// A number of CurvePoint. Integers pass through double exactly.
struct CurveColumn {
  std::string_view name;
  std::string_view unit;
  ColumnRange range;
  bool is_integer;
  double (*get)(const CurvePoint&);
  void (*set)(CurvePoint&, double);
};

/// All numbers of a CurvePoint; `note` is not among them.
std::span<const CurveColumn> curve_columns();

/// The column of that name; null if there is none.
const CurveColumn* find_curve_column(std::string_view name);

/// The column of that name.
/// @throws std::domain_error  there is none
const CurveColumn& curve_column(std::string_view name);

/// "converged", "not_converged".
std::string_view status_word(StepStatus status);

} // namespace asperity::results
