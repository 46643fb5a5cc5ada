#pragma once

// The published and exact values of a case: reference.csv.

#include <string>
#include <vector>

namespace asperity::cases {

/// One line of reference.csv.
struct ReferenceValue {
  /// The name of an expectation, possibly at a load ("area_fraction@p=0.01
  /// E*"), or another name without '@'.
  std::string quantity;
  double value = 0.0;
  std::string unit;         ///< "1" for dimensionless values
  double uncertainty = 0.0; ///< in the same unit, 0 for an exact value
  std::string source;       ///< paper and place in it, or the formula
  /// Why the value cannot follow from what its source states; empty if it can.
  std::string why = {};
  /// What in the case was chosen to reproduce the value, so that agreement is
  /// not evidence; empty if nothing was.
  std::string input = {};
};

/// Reads a file whose first line is quantity,value,unit,uncertainty,source,
/// followed by ",why" or ",why,input" if the lines have these fields. Fields
/// may be in double quotes, and "" inside them is one quote. Empty lines and
/// lines that begin with # are skipped.
///
/// @throws input::InputError  lists all mistakes with their lines
std::vector<ReferenceValue> read_reference(const std::string& path);

/// Reads the same format from a text; `path` is used in messages.
std::vector<ReferenceValue> read_reference_text(const std::string& text,
                                                const std::string& path);

} // namespace asperity::cases
