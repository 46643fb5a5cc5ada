#pragma once

// Compares two results or cases: the keys of the cases, the files they name,
// the builds, and the numbers of each method at each load.

#include "input/types/case.hpp"
#include "results/types/result.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity::run {

/// One side of the comparison. A case has no result; the result of another
/// program may have no case.
struct ComparedSide {
  std::string path;
  std::optional<cases::Case> contact_case;
  std::map<std::string, std::string> inputs; ///< SHA-256 of the case's files
  std::optional<results::Result> result;
};

/// A text that differs; "" where one side has none.
struct TextDifference {
  std::string name;
  std::string one;
  std::string other;
};

/// The column of one row that differs most.
struct NumberDifference {
  std::string method; ///< or "surface"
  int realization = 0;
  int step = 0;       ///< 0 for a surface
  std::string column; ///< "mean_gap"
  double one = 0.0;
  double other = 0.0;
  double relative = 0.0; ///< [1] > 0; infinite where only one side is a number
};

/// The largest difference of each method.
struct MethodDifference {
  std::string method;
  int rows = 0;                  ///< that both sides have
  int rows_that_differ = 0;      ///< by more than the tolerance
  NumberDifference largest = {}; ///< relative = 0: all numbers are equal
  std::vector<NumberDifference> rows_listed = {}; ///< one for each that differs
};

/// How two sides differ.
struct Difference {
  std::vector<TextDifference> keys;    ///< of the case, in SI units
  std::vector<TextDifference> inputs;  ///< by the key that names the file
  std::vector<TextDifference> build;   ///< program, libraries, machine
  std::vector<TextDifference> missing; ///< methods and rows of one side only
  std::vector<MethodDifference> methods;
  bool has_numbers = false; ///< both sides are results

  /// Returns whether cases, files or numbers differ. The build does not count:
  /// equal numbers of two builds are what a comparison is to show.
  bool is_any() const;
};

/// Compares two sides.
///
/// @param tolerance  largest relative difference [1] that counts as equal. The
///     difference of two numbers is relative to the larger one, that of mean
///     gaps at least to h_rms. With 0, counts of iterations and residuals are
///     compared, too. Times and memory are never compared.
Difference difference_of(const ComparedSide& one, const ComparedSide& other,
                         double tolerance);

/// Formats the difference as readable text, and as JSON.
std::string difference_text(const Difference& difference, double tolerance);
std::string difference_json(const Difference& difference, double tolerance);

} // namespace asperity::run
