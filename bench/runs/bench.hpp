#pragma once

// asperity bench: what each setting of each method costs and how far its
// answer is from the truth, and a report of that.

#include "app/run/exit_code.hpp"

#include <string>
#include <vector>

namespace asperity::app {

struct BenchCommand {
  std::string contact_case; ///< file, folder or name of a shipped case
  std::vector<std::string> methods;
  std::vector<std::string> overrides; ///< "key.path=value"
  std::string out;                    ///< empty: out/<case>/bench
  int repeats = 3;
  int realizations = 1;
  double budget = 300.0;    ///< wall time after which a setting is run once and
                            ///< axes other than points are left out [s]
  bool is_quick = false;    ///< quick.set laid over the case, points alone, one
                            ///< repeat
  std::string target_error; ///< "1%"; empty: none asked
};

/// @throws cases::CaseError  mistakes in the case, a collection, a method that
///                           is not there
ExitCode bench_case(const BenchCommand& command);

/// "1%", "1 %", "0.01" as 0.01.
/// @throws cases::CaseError  none of these, or outside 0 .. 1
double read_target_error(const std::string& text);

} // namespace asperity::app
