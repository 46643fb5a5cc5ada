#pragma once

// The published and exact numbers beside a case: reference.csv.

#include <string>
#include <vector>

namespace asperity::cases {

/// One line of reference.csv.
struct ReferenceValue {
  /// An expectation's name, or one at a load ("area_fraction@p=0.01 E*"), or a
  /// name of its own, without '@'.
  std::string quantity;
  double value = 0.0;
  std::string unit;         ///< "1" for none
  double uncertainty = 0.0; ///< in the same unit, 0 for an exact value
  std::string source;       ///< paper and place, or the formula
  /// Why the number cannot follow from what its source states; empty: it can.
  std::string why = {};
  /// What of the case was chosen to meet the number, so that meeting it is no
  /// finding; empty: nothing.
  std::string input = {};
};

/// Read a file whose first line is quantity,value,unit,uncertainty,source, with
/// ",why" or ",why,input" behind it if the lines have those fields too, and
/// whose fields may stand in double quotes ("" inside them is one quote). Empty
/// lines and lines that begin with # are skipped.
/// @throws CaseError  every mistake with its line
std::vector<ReferenceValue> read_reference(const std::string& path);

/// The same from a text; `path` is for messages.
std::vector<ReferenceValue> read_reference_text(const std::string& text,
                                                const std::string& path);

} // namespace asperity::cases
