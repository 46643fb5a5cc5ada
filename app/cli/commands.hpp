#pragma once

// What each command of the program does, from words to an exit code.

#include "app/run/exit_code.hpp"

#include <string>
#include <vector>

namespace asperity::app {

struct RunCommand {
  std::vector<std::string> cases; ///< files, folders, names of shipped cases
  std::vector<std::string> methods;
  std::vector<std::string> overrides; ///< "key.path=value"
  std::string out; ///< empty: out/<case>; several cases: a folder in it each
  bool resume = false;
  bool is_quick = false; ///< quick.set of each case laid over it
  int threads = 0;
  bool is_exact = false;         ///< `methods` are names alone, no kinds
  std::string target_error = {}; ///< "1%"; empty: the case's own settings
  bool no_report = false;        ///< result.h5 alone, as a benchmark wants it
  bool uses_cache = true;
  bool is_dry = false; ///< print the plan, run nothing
};

/// Every case is read before the first is run. After the parts of a collection
/// comes the report on all of them, in out/<collection>.
ExitCode run_cases(const RunCommand& command);

/// One report over several results, in `out` (empty: beside a single result,
/// else out/comparison).
ExitCode report_results(const std::vector<std::string>& results,
                        const std::string& out);

/// Every case among the targets is read before the first is run.
/// @param targets  results (file or folder), or cases, which are run first
/// @param junit    file for JUnit XML; empty: none
ExitCode check_targets(const std::vector<std::string>& targets,
                       const std::string& junit, bool uses_cache = true);

/// Where the cache is, how much of it is used; emptied before if asked to.
ExitCode show_cache(bool is_to_clear);

ExitCode list_cases();

/// Writes name/case.toml. @throws cases::CaseError  it is there already
ExitCode new_case(const std::string& name);

ExitCode print_schema();

} // namespace asperity::app
