#pragma once

// Parts of the command line that several commands share.

#include "app/run/exit_code.hpp"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace asperity::app {

/// The chosen command, which is called after the command line is parsed.
using Action = std::function<ExitCode()>;

/// Adds an example line to the help of a command, before the footer that all
/// commands share.
inline void add_example(CLI::App* command, const std::string& line) {
  command->footer("example:\n  asperity " + line + "\n\n" +
                  command->get_footer());
}

/// Adds --set, by which a key of the case file is overridden.
inline void add_overrides(CLI::App* command,
                          std::vector<std::string>& overrides) {
  command
      ->add_option("--set", overrides,
                   "override a key of the case file, e.g.\n"
                   "surface.points=128; may be repeated")
      ->allow_extra_args(false);
}

} // namespace asperity::app
