#pragma once

// What the options --quiet and --json do with the standard output of a command:
// the text that it prints is discarded, or goes to standard error, so that only
// the answer of the command is left.

#include <filesystem>
#include <string>

namespace asperity::run {

/// The options --quiet and --json of the chosen command.
struct OutputOptions {
  bool is_quiet = false; ///< print errors only
  bool is_json = false;  ///< print the answer as JSON
};

/// While it lives, text for standard output goes to standard error (--json) or
/// nowhere (--quiet), also that of libraries and child processes. There is at
/// most one.
class OutputScope {
public:
  /// @throws std::system_error  the output cannot be redirected
  explicit OutputScope(const OutputOptions& options);
  ~OutputScope(); ///< restores standard output

  OutputScope(const OutputScope&) = delete;
  OutputScope& operator=(const OutputScope&) = delete;
};

/// Return whether the chosen command has the option.
bool wants_json();
bool wants_quiet();

/// Writes the answer of a command to standard output, whatever the options.
/// @throws std::system_error  it cannot be written
void emit_answer(const std::string& text);

/// Returns the text of a JSON file as the answer of a command, or null if there
/// is no such file.
std::string json_of_file(const std::filesystem::path& path);

} // namespace asperity::run
