#pragma once

// asperity bench measures the cost of each setting of each method and its error
// with respect to the reference solution, and writes a report.

#include "run/exit_code.hpp"

#include <string>
#include <vector>

namespace asperity::bench {

struct BenchCommand {
  std::string contact_case; ///< file, folder or name of an installed case
  std::vector<std::string> methods;
  std::vector<std::string> overrides; ///< "key.path=value"
  std::string out;                    ///< empty: out/<case>/bench
  int repeats = 3;
  int realizations = 1;
  /// Wall time after which each setting is run once and axes other than points
  /// are omitted [s]
  double budget = 300.0;
  /// Applies quick.set to the case; points only, one repeat.
  bool is_quick = false;
  std::string target_error; ///< "1%"; empty: no target
};

/// @throws input::InputError  the case has mistakes, is a collection, or lacks
///                            a
///     requested method
run::ExitCode bench_case(const BenchCommand& command);

/// Reads "1%", "1 %" or "0.01" as 0.01.
/// @throws input::InputError  none of these, or outside 0 .. 1
double read_target_error(const std::string& text);

} // namespace asperity::bench
