#pragma once

// The command that tests results against the expectations of their cases, for
// CI jobs.

#include "cli/command_parts.hpp"

#include <string>
#include <vector>

namespace asperity::cli {

/// Options of `asperity check`. All but the first two concern targets that are
/// cases.
struct CheckCommand {
  std::vector<std::string> targets; ///< results (file or folder), or cases
  std::string junit;                ///< file for JUnit XML; empty: none
  std::string out;                  ///< as in RunCommand
  std::vector<std::string> methods;
  std::vector<std::string> overrides; ///< "key.path=value"
  bool is_quick = false;              ///< apply quick.set of each case
  int threads = 0;
  bool uses_cache = true;
};

void add_check(CLI::App& program, CheckCommand& check,
               run::OutputOptions& output, Action& action);

/// Checks results against the expectations of their cases. All cases among the
/// targets are read before the first one is run. The JUnit file is written
/// however the command ends.
///
/// @throws input::InputError  a target cannot be read, the folder of the JUnit
///                            file does not exist, or an option for cases is
///                            given without a case
run::ExitCode check_targets(const CheckCommand& command);

} // namespace asperity::cli
