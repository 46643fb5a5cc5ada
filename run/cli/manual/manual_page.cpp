// Generates the manual pages, in the format of man(7).
#include "base/atomic_file.hpp"
#include "input/input_error.hpp"
#include "input/nearest.hpp"
#include "run/cli/manual/command_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace asperity::cli {
namespace {

constexpr const char* exit_codes = R"(.SH EXIT STATUS
.TP
.B 0
Success.
.TP
.B 1
An expectation is not met or is undecided, or what was compared differs.
.TP
.B 2
Invalid input: command line, case or file.
.TP
.B 3
A solution did not converge.
.TP
.B 4
System or library error.
.TP
.B 130
Interrupted; finished load steps are saved, and
.B asperity run \-\-resume
continues.
)";

constexpr const char* environment = R"(.SH ENVIRONMENT
.TP
.B ASPERITY_CACHE
Folder of the step cache; by default
.IR $XDG_CACHE_HOME/asperity ,
else
.IR ~/.cache/asperity .
.TP
.B ASPERITY_CACHE_SIZE
Size limit of the cache, for example
.RB \(dq "500 MB" \(dq;
by default 2 GB, 0 for no cache.
)";

/// Escapes what is special to roff: backslashes, hyphens, and a dot or an
/// apostrophe at the beginning of a line.
std::string roff(const std::string& text) {
  std::string escaped;
  for (const char letter : text)
    switch (letter) {
    case '\\':
      escaped += "\\e";
      break;
    case '-':
      escaped += "\\-";
      break;
    case '\'':
      escaped += "\\(aq";
      break;
    default:
      escaped += letter;
    }
  return escaped.starts_with('.') ? "\\&" + escaped : escaped;
}

/// Returns a sentence: a capital letter first and a full stop last.
std::string sentence(std::string text) {
  if (text.empty())
    return text;
  text[0] =
      static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.ends_with('.') ? text : text + ".";
}

std::string head(const ProgramModel& model, const std::string& title,
                 const std::string& description) {
  return fmt::format(".TH {} 1 \"\" \"asperity {}\" \"User Commands\"\n"
                     ".SH NAME\n{} \\- {}\n",
                     title, roff(model.version), roff(title),
                     roff(description));
}

/// Formats "\fB\-\-out\fR \fIDIR\fR".
std::string term(const OptionModel& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names)
    names.push_back((option.is_argument ? "\\fI" : "\\fB") + roff(name) +
                    "\\fR");
  std::string text = fmt::format("{}", fmt::join(names, ", "));
  if (!option.is_argument && !option.value.empty())
    text += " \\fI" + roff(option.value) + "\\fR";
  return text;
}

std::string options_section(const std::vector<OptionModel>& options,
                            bool is_arguments) {
  std::string text;
  for (const OptionModel& option : options)
    if (option.is_argument == is_arguments)
      text += ".TP\n" + term(option) + "\n" +
              roff(sentence(option.description)) + "\n";
  if (text.empty())
    return "";
  return (is_arguments ? ".SH ARGUMENTS\n" : ".SH OPTIONS\n") + text;
}

std::string program_page(const ProgramModel& model) {
  std::string text =
      head(model, "asperity", "rough elastic contact from one case file") +
      ".SH SYNOPSIS\n.B asperity\n.I COMMAND\n.RI [ OPTIONS ]\n"
      ".SH DESCRIPTION\n" +
      roff(sentence(model.program.description)) + "\n.SH COMMANDS\n";
  std::vector<std::string> pages;
  for (const CommandModel& command : model.commands) {
    text += ".TP\n.B " + roff(command.name) + "\n" +
            roff(sentence(command.description)) + "\n";
    pages.push_back(".BR asperity\\-" + roff(command.name) + " (1)");
  }
  std::sort(pages.begin(), pages.end());
  return text + options_section(model.program.options, false) + exit_codes +
         environment +
         fmt::format(".SH SEE ALSO\n{}\n", fmt::join(pages, ",\n"));
}

std::string command_page(const ProgramModel& model,
                         const CommandModel& command) {
  std::string text =
      head(model, "asperity-" + command.name,
           command.description.ends_with('.')
               ? command.description.substr(0, command.description.size() - 1)
               : command.description) +
      ".SH SYNOPSIS\n.B asperity " + roff(command.name) + "\n";
  for (const OptionModel& option : command.options)
    if (option.is_argument)
      text += option.is_needed ? ".I " + roff(option.names.front()) + "\n"
                               : ".RI [ " + roff(option.names.front()) + " ]\n";
  text += ".RI [ OPTIONS ]\n.SH DESCRIPTION\n" +
          roff(sentence(command.description)) + "\n" +
          options_section(command.options, true) +
          options_section(command.options, false);
  if (!command.example.empty())
    text += ".SH EXAMPLES\n.nf\nasperity " + roff(command.example) + "\n.fi\n";
  return text + exit_codes + ".SH SEE ALSO\n.BR asperity (1)\n";
}

} // namespace

std::string manual_page(const ProgramModel& model, const std::string& command) {
  if (command.empty())
    return program_page(model);
  std::vector<std::string> names;
  for (const CommandModel& one : model.commands) {
    if (one.name == command)
      return command_page(model, one);
    names.push_back(one.name);
  }
  throw input::InputError("there is no command " + command +
                          "; nearest: " + input::nearest(command, names));
}

void write_manual(const ProgramModel& model, const std::string& folder) {
  std::filesystem::create_directories(folder);
  const std::filesystem::path pages(folder);
  write_file_atomically(pages / "asperity.1", manual_page(model, ""));
  for (const CommandModel& command : model.commands)
    write_file_atomically(pages / ("asperity-" + command.name + ".1"),
                          manual_page(model, command.name));
}

} // namespace asperity::cli
