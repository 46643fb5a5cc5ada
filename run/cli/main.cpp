// The command line of the program: maps arguments to commands and failures to
// exit codes.
#include "base/array_memory.hpp"
#include "base/plain_text.hpp"
#include "input/nearest.hpp"
#include "run/arguments/case_library.hpp"
#include "run/cli/checks.hpp"
#include "run/cli/command_line.hpp"
#include "run/cli/manual/command_model.hpp"
#include "run/mpi_world.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace asperity::cli {
namespace {

/// Returns a line with the nearest command or option for the first word of the
/// command line that is neither; "" if there is none.
std::string nearest_word(const CLI::App& program, int argc, char** argv) {
  const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const CLI::App* command = &program;
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    std::vector<std::string> known;
    if (name.starts_with("--"))
      for (const CLI::Option* option : command->get_options())
        for (const std::string& option_name : option->get_lnames())
          known.push_back("--" + option_name);
    else if (command == &program && !name.starts_with('-'))
      for (const CLI::App* one :
           program.get_subcommands([](const CLI::App*) { return true; })) {
        known.push_back(one->get_name());
        for (const std::string& alias : one->get_aliases())
          known.push_back(alias);
      }
    if (known.empty())
      continue;
    if (std::ranges::find(known, name) == known.end())
      return fmt::format("{}: did you mean {}?\n", printable(name),
                         input::nearest(name, known));
    if (command == &program && !name.starts_with("--"))
      command = program.get_subcommand(name);
  }
  return "";
}

int run(int argc, char** argv) {
  CommandLine line{CLI::App(
      "Asperity: rough contact by finite elements, a half-space, atoms and "
      "Persson's\ntheory, computed from one case file and compared in one "
      "report.")};
  CLI::App& program = line.program;
  program.name("asperity");
  program.require_subcommand(1);
  program.set_version_flag("--version", ASPERITY_VERSION);
  program.footer(
      "exit codes:\n  0 success, 1 an expectation is not met, 2 invalid "
      "input, 3 a solution did not\n  converge, 4 system or "
      "library error, 130 interrupted\n\ndocumentation: " +
      run::documentation_folder().string());
  for (const AddCommand add : all_commands)
    add(line);
  name_values(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (program.exit(error) == 0)
      return run::exit_good;
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
        dynamic_cast<const CLI::RequiredError*>(&error) != nullptr)
      fmt::print(stderr, "{}", nearest_word(program, argc, argv));
    return run::exit_bad_input;
  }
  const run::OutputScope scope(line.output);
  return line.action();
}

/// Opens /dev/null for those of standard input, output and error that are
/// closed. Otherwise files that are opened later would take their numbers, and
/// text for a terminal would be written into them.
void open_standard_descriptors() {
  for (int number = 0; number <= STDERR_FILENO; ++number)
    if (fcntl(number, F_GETFD) < 0) // open() returns the least free number
      static_cast<void>(open("/dev/null", number == 0 ? O_RDONLY : O_WRONLY));
}

/// Prints why the program ends. That standard error cannot be written changes
/// nothing.
void complain(const std::string& text) {
  std::fputs((text + "\n").c_str(), stderr);
}

} // namespace
} // namespace asperity::cli

int main(int argc, char** argv) {
  using asperity::cli::complain;
  asperity::cli::open_standard_descriptors();
  asperity::keep_freed_memory();
  std::signal(SIGXFSZ, SIG_IGN); // exceeding a file size limit is an ordinary
                                 // error
  try {
    const int end = asperity::run::has_followed_rank_0()
                        ? asperity::run::exit_good
                        : asperity::cli::run(argc, argv);
    if (std::fflush(stdout) != 0)
      throw std::system_error(errno, std::generic_category(),
                              "cannot write standard output");
    return end;
  } catch (const std::exception& error) {
    const asperity::cli::Failure failure = asperity::cli::failure_of(error);
    complain(failure.text);
    if (failure.exit_code == asperity::run::exit_internal)
      asperity::run::end_at_once_of_several(failure.exit_code);
    return failure.exit_code;
  }
}
