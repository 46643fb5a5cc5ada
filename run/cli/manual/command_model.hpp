#pragma once

// The commands and options of the program as plain data, read from the command
// line parser: what shell completions and manual pages are generated from.

#include <CLI/CLI.hpp>

#include <set>
#include <string>
#include <vector>

namespace asperity::cli {

/// An option, or an argument without a name.
struct OptionModel {
  std::vector<std::string> names; ///< "--out"; for an argument its name
  std::string value;              ///< "DIR"; "" for a flag
  std::string description;        ///< one line
  bool is_argument = false;
  bool is_needed = false;
};

/// A command, or the program itself with the options of all commands.
struct CommandModel {
  std::string name;
  std::string description; ///< one line
  std::string example;     ///< without the name of the program; may be empty
  std::vector<OptionModel> options;
  bool is_on_cases = false; ///< its arguments are cases
};

/// The whole program. Hidden commands are left out.
struct ProgramModel {
  CommandModel program;
  std::string version;
  std::vector<CommandModel> commands;
};

/// @param on_cases  commands whose arguments are cases
ProgramModel model_of(const CLI::App& program,
                      const std::set<std::string>& on_cases);

/// Names the values of options in the help texts: --out DIR.
void name_values(CLI::App& program);

/// Returns the completion script for a shell.
/// @param shell  bash, zsh or fish
std::string completion_script(const ProgramModel& model,
                              const std::string& shell);

/// Returns a manual page in the format of man(7).
/// @param command  name of a command; empty: the page of the program
/// @throws input::InputError  there is no such command
std::string manual_page(const ProgramModel& model, const std::string& command);

/// Writes the pages of the program and of all commands, such as asperity-run.1.
/// @throws std::system_error  the folder cannot be written
void write_manual(const ProgramModel& model, const std::string& folder);

} // namespace asperity::cli
