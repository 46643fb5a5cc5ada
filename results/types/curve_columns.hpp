#pragma once

// The columns of a curve: their names, units, ranges and order. The HDF5 writer
// and reader, the validity checks and the CSV file are all derived from this
// table.

#include "results/types/result.hpp"

#include <span>
#include <string>
#include <string_view>

namespace asperity::results {

/// Range of a number, including both ends. Ranges that end at 1 allow for a
/// roundoff error of 1e-9. NaN, "not determined", is allowed unless is_needed
/// is set.
struct ColumnRange {
  double lowest;
  double highest;
  bool is_needed = false; ///< finite in every converged step

  /// Returns "must lie between 0 and 1", "must be finite and >= 0" etc.
  std::string text() const;

  /// Returns whether the number is within the range; false for NaN.
  bool holds(double number) const;
};

inline constexpr ColumnRange not_negative{0.0,
                                          std::numeric_limits<double>::max()};

/// Whether a number is the same for the user's map and for the cell that a
/// solver presses (map_in_cell.hpp), or in proportion to the area.
enum class Extent { intensive, extensive };

/// Description of one number of CurvePoint. Integers are converted to double
/// exactly.
struct CurveColumn {
  std::string_view name;
  std::string_view unit;
  ColumnRange range;
  bool is_integer;
  Extent extent;
  double (*get)(const CurvePoint&);
  void (*set)(CurvePoint&, double);
};

/// Returns all numerical columns of CurvePoint; `note` is not among them.
std::span<const CurveColumn> curve_columns();

/// Returns the column of that name, or null if there is none.
const CurveColumn* find_curve_column(std::string_view name);

/// Returns the column of that name.
/// @throws std::domain_error  there is none
const CurveColumn& curve_column(std::string_view name);

/// Makes the extensive numbers of a row, which are those of the cell that a
/// solver presses, those of the user's map.
/// @param share  MapInCell::share() of the surface
void state_of_map(CurvePoint& row, double share);

/// Returns "converged" or "not_converged".
std::string_view status_word(StepStatus status);

} // namespace asperity::results
