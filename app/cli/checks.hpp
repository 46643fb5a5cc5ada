#pragma once

// What the program says of the verdicts on results, and the exit code that
// follows from them.

#include "app/run/exit_code.hpp"
#include "reports/analysis/summary.hpp"

#include <string>
#include <vector>

namespace asperity::app {

/// The worse of two ends: what cannot be trusted before what is out of band.
ExitCode worse(ExitCode one, ExitCode other);

/// A line each: verdicts, published values, methods with steps that did not
/// converge, what could not be worked out.
void print_verdicts(const reports::Summary& summary);

/// That of a run: steps that did not converge before expectations not passed.
ExitCode exit_code_of(const reports::Summary& summary);

/// What `check` has found so far, over all its targets.
class Checks {
public:
  /// Judges a result of the target at hand and says what came of it.
  void add(reports::Summary summary);

  /// Of a case that has no result to be judged: a failed check of that name.
  void add_problem(const std::string& case_name, const std::string& problem,
                   ExitCode exit_code);

  /// A target of which nothing was checked is bad input: exit code 0 would say
  /// that it was checked, 1 that an expectation is not passed.
  void end_target(const std::string& target);

  /// Writes the JUnit file of what was judged; empty: none.
  /// @return  the worst end of all targets
  ExitCode end(const std::string& junit) const;

private:
  std::vector<reports::Summary> summaries_;
  ExitCode end_ = exit_good;
  bool has_checked_ = false; ///< something of the target at hand
  std::string why_nothing_;  ///< of its last result
};

} // namespace asperity::app
