#pragma once

// The options of the commands that look at cases and results without running
// anything: describe, diff, and the hidden ones that generate shell completions
// and manual pages.

#include "cli/command_parts.hpp"
#include "cli/describe_command.hpp"
#include "cli/diff_command.hpp"

#include <string>

namespace asperity::cli {

/// What the command line says of each.
struct InspectCommands {
  DescribeCommand describe;
  DiffCommand diff;
  std::string shell;        ///< of `completion`
  std::string page;         ///< of `man`; empty: the program
  std::string pages_folder; ///< for all pages; empty: print one
};

/// @param commands, output, action  must outlive the parsing of the command
///                                  line
void add_inspect_commands(CLI::App& program, InspectCommands& commands,
                          run::OutputOptions& output, Action& action);

} // namespace asperity::cli
