#pragma once

// Prints the verdicts on results and derives the exit code from them.

#include "reports/analysis/summary.hpp"
#include "run/exit_code.hpp"
#include "run/result_outputs.hpp"

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity::cli {

/// Returns the more severe of two exit codes. A result that cannot be trusted
/// is more severe than one outside its expected range.
run::ExitCode worse(run::ExitCode one, run::ExitCode other);

/// How a command, or one of its targets, ends by an exception.
struct Failure {
  std::string text; ///< for the user
  run::ExitCode exit_code = run::exit_internal;
};

/// What is refused is bad input, as is the name of a file that no file can
/// have; all else is an internal error.
Failure failure_of(const std::exception& error);

/// Prints one line for each verdict, each published value, each method with
/// load steps that did not converge, and each quantity that could not be
/// evaluated.
void print_verdicts(const reports::Summary& summary);

/// Returns the exit code of a run. Load steps that did not converge take
/// precedence over expectations that are not met.
run::ExitCode exit_code_of(const reports::Summary& summary);

/// Prints the findings of the report in a folder.
/// @return  exit_code_of() its summary
run::ExitCode print_findings(const reports::Summary& summary,
                             const std::filesystem::path& folder);

/// Collects the findings of `check` over all of its targets.
class Checks {
public:
  /// Verifies a result of the current target and prints the outcome.
  void add(const std::filesystem::path& folder, reports::Summary summary);

  /// Records a case without a result as a failed check under the name of the
  /// case.
  void add_problem(const std::string& case_name, const std::string& problem,
                   run::ExitCode exit_code);

  /// Finishes the current target. A target for which nothing was checked counts
  /// as bad input: exit code 0 would claim that it was checked, and 1 that an
  /// expectation is not met.
  /// @param has_failed  it was recorded as a problem
  void end_target(const std::string& target, bool has_failed = false);

  /// Writes the JUnit file of all checks unless `junit` is empty, and what
  /// --json prints.
  /// @return  the most severe exit code of all targets
  run::ExitCode end(const std::string& junit) const;

private:
  std::vector<reports::Summary> summaries_;
  run::JsonAnswer answer_{"asperity-check"};
  run::ExitCode end_ = run::exit_good;
  bool has_checked_ = false; ///< whether any check of this target was made
  std::string why_nothing_;  ///< why its last result was not checked
};

} // namespace asperity::cli
