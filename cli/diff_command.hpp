#pragma once

// The command that compares two results or cases.

#include "run/exit_code.hpp"

#include <string>

namespace asperity::cli {

/// Options of `asperity diff`.
struct DiffCommand {
  std::string one; ///< result (file or folder) or case
  std::string other;
  double tolerance = 0.0; ///< relative [1] >= 0
};

/// Prints how two results or cases differ.
/// @return  exit_expectation_failed if they differ
/// @throws input::InputError  one of them cannot be read, or is a collection
run::ExitCode diff_two(const DiffCommand& command);

} // namespace asperity::cli
