#pragma once

// How the program ends, for shells and CI jobs.

namespace asperity::app {

enum ExitCode : int {
  exit_good = 0,
  exit_expectation_failed = 1,
  exit_bad_input = 2,
  exit_numerics_gave_up = 3,
  exit_internal = 4,      ///< disk full, no memory, a library that fails
  exit_interrupted = 130, ///< as shells say it for Ctrl-C
};

} // namespace asperity::app
