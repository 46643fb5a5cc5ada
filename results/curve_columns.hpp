#pragma once

// The columns of a curve: their names, units and order. The one table that
// the HDF5 writer, its reader and the CSV file are made from.

#include "results/result.hpp"

#include <span>
#include <string_view>

namespace asperity::results {

/// A number of CurvePoint. Integers pass through double exactly.
struct CurveColumn {
  std::string_view name;
  std::string_view unit;
  bool is_integer;
  double (*get)(const CurvePoint&);
  void (*set)(CurvePoint&, double);
};

/// All numbers of a CurvePoint; `note` is not among them.
std::span<const CurveColumn> curve_columns();

/// The column of that name.
/// @throws std::domain_error  there is none
const CurveColumn& curve_column(std::string_view name);

/// "converged", "not_converged".
std::string_view status_word(StepStatus status);

} // namespace asperity::results
