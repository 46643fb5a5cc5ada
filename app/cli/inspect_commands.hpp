#pragma once

// The options of the commands that look at cases and results without running
// anything: describe and diff.

#include "app/cli/command_parts.hpp"
#include "app/cli/describe_command.hpp"
#include "app/cli/diff_command.hpp"

namespace asperity::app {

/// What the command line says of each.
struct InspectCommands {
  DescribeCommand describe;
  DiffCommand diff;
};

/// @param commands, output, action  must outlive the parsing of the command
///                                  line
void add_inspect_commands(CLI::App& program, InspectCommands& commands,
                          OutputOptions& output, Action& action);

} // namespace asperity::app
