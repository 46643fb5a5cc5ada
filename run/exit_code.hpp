#pragma once

// The exit codes of the program for shells and CI jobs.

namespace asperity::run {

enum ExitCode : int {
  exit_good = 0,
  exit_expectation_failed = 1,
  exit_bad_input = 2,
  exit_not_converged = 3,
  exit_internal = 4,      ///< disk full, out of memory, library failure
  exit_interrupted = 130, ///< shell convention for Ctrl-C
};

} // namespace asperity::run
