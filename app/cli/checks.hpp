#pragma once

// Prints the verdicts on results and derives the exit code from them.

#include "app/run/exit_code.hpp"
#include "app/run/result_outputs.hpp"
#include "reports/analysis/summary.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::app {

/// Returns the more severe of two exit codes. A result that cannot be trusted
/// is more severe than one outside its expected range.
ExitCode worse(ExitCode one, ExitCode other);

/// Prints one line for each verdict, each published value, each method with
/// load steps that did not converge, and each quantity that could not be
/// evaluated.
void print_verdicts(const reports::Summary& summary);

/// Returns the exit code of a run. Load steps that did not converge take
/// precedence over expectations that are not met.
ExitCode exit_code_of(const reports::Summary& summary);

/// Prints the findings of the report in a folder.
/// @return  exit_code_of() its summary
ExitCode print_findings(const reports::Summary& summary,
                        const std::filesystem::path& folder);

/// Collects the findings of `check` over all of its targets.
class Checks {
public:
  /// Verifies a result of the current target and prints the outcome.
  void add(const std::filesystem::path& folder, reports::Summary summary);

  /// Records a case without a result as a failed check under the name of the
  /// case.
  void add_problem(const std::string& case_name, const std::string& problem,
                   ExitCode exit_code);

  /// Finishes the current target. A target for which nothing was checked counts
  /// as bad input: exit code 0 would claim that it was checked, and 1 that an
  /// expectation is not met.
  void end_target(const std::string& target);

  /// Writes the JUnit file of all checks unless `junit` is empty, and what
  /// --json prints.
  /// @return  the most severe exit code of all targets
  ExitCode end(const std::string& junit) const;

private:
  std::vector<reports::Summary> summaries_;
  JsonAnswer answer_{"asperity-check"};
  ExitCode end_ = exit_good;
  bool has_checked_ = false; ///< whether any check of this target was made
  std::string why_nothing_;  ///< why its last result was not checked
};

} // namespace asperity::app
