// The command line of the program: maps arguments to commands and failures to
// exit codes.
#include "base/array_memory.hpp"
#include "base/folder_lock.hpp"
#include "base/plain_text.hpp"
#include "bench/runs/bench.hpp"
#include "cli/commands.hpp"
#include "cli/manual/command_model.hpp"
#include "input/input_error.hpp"
#include "input/nearest.hpp"
#include "run/arguments/case_library.hpp"
#include "run/mpi_world.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

namespace asperity::cli {
namespace {

// What a map's file leaves open, and the physics of its surface.
void add_map_options(CLI::App* command, RunCommand& run) {
  command->add_option("--contact-modulus", run.contact_modulus,
                      "E* of the block under a map file, e.g. \"2 GPa\"");
  command->add_option("--length", run.length,
                      "side length in x of a map whose file states none,\n"
                      "e.g. \"20 um\"");
  command->add_option("--height-unit", run.height_unit,
                      "unit of the heights of such a map, e.g. nm");
  command->add_option("--flow", run.flow,
                      "fluid that leaks through the gap: water, air, or a\n"
                      "viscosity, e.g. \"0.1 Pa s\"; the pressure drop is\n"
                      "100 kPa or flow.pressure_drop");
  command->add_option(
      "--work-of-adhesion", run.work_of_adhesion,
      "of the faces of a half-space, e.g. \"50 mJ/m^2\"; a map\n"
      "is pressed and pulled off");
  command->add_option("--friction", run.friction,
                      "coefficient of friction, for partial slip under the\n"
                      "largest load");
  command->add_option("--hardness", run.hardness,
                      "largest contact pressure of the half-space and of\n"
                      "the theory of a map, e.g. \"2 GPa\"");
}

void add_run(CommandLine& line) {
  auto [command, run] =
      line.add<RunCommand>("run",
                           "Run cases; write result, tables and report\n"
                           "of each.",
                           run_cases);
  command
      ->add_option("case", run.cases,
                   "case files, their folders, shipped cases or\n"
                   "collections (see 'asperity list'), or measured\n"
                   "maps")
      ->required();
  add_methods(command, run.methods);
  add_map_options(command, run);
  add_overrides(command, run.overrides);
  command->add_option("--out", run.out, "output folder (default: out/<case>)");
  command->add_flag("--resume", run.resume,
                    "compute the steps missing from an earlier run");
  add_quick(command, run.is_quick);
  CLI::Option* target =
      command->add_option("--target-error", run.target_error,
                          "use the cheapest setting whose predicted error is\n"
                          "smaller, e.g. 1%; a finer run verifies the error");
  command->add_flag("--exactly", run.is_exact,
                    "--methods gives full names only: fem does not\n"
                    "include fem.hard");
  command->add_flag("--no-report", run.no_report, "write result.h5 only");
  CLI::Option* pdf =
      command->add_flag("--pdf", run.has_pdf,
                        "also print the report to report.pdf, by chromium\n"
                        "or weasyprint");
  command->add_flag("--dry-run", run.is_dry,
                    "print the plan, the predicted memory and what is\n"
                    "skipped; write nothing");
  command->add_flag("!--no-cache", run.uses_cache,
                    "compute every step; do not read or write the cache");
  command
      ->add_option("--part", run.part,
                   "compute one of N shares of the realisations or\n"
                   "points, I/N as in 3/8; 'asperity merge' joins them")
      ->excludes(target)
      ->excludes(pdf);
  add_threads(command, run.threads);
  add_quiet(command, line.output);
  add_json(command, line.output, "the summaries, or the plans,");
  add_example(command, "run polymer --methods fem,theory --set "
                       "surface.points=128");
}

void add_bench(CommandLine& line) {
  auto [command, bench] = line.add<bench::BenchCommand>(
      "bench",
      "Measure, for each setting of a case's\n"
      "methods, its cost and its error against the\n"
      "reference solution.",
      run_bench);
  command
      ->add_option("case", bench.contact_case,
                   "case file, its folder or shipped case")
      ->required();
  add_methods(command, bench.methods);
  add_overrides(command, bench.overrides);
  command->add_option("--out", bench.out,
                      "output folder (default: out/<case>/bench)");
  command
      ->add_option("--repeats", bench.repeats,
                   "timed runs per setting, after one warm-up run")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--realizations", bench.realizations,
                   "largest number of realisations")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--budget", bench.budget,
                   "time [s] after which each setting is run once and\n"
                   "settings other than the points are skipped")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--quick", bench.is_quick,
                    "apply quick.set, vary only the points, time one run\n"
                    "of each: about a minute");
  command->add_option("--target-error", bench.target_error,
                      "also choose the cheapest setting with a smaller\n"
                      "error, e.g. 1%");
  add_quiet(command, line.output);
  add_json(command, line.output, "bench.json");
  add_example(command, "bench hertz --target-error 1%");
}

void add_report(CommandLine& line) {
  auto [command, report] =
      line.add<ReportCommand>("report",
                              "Write the report of one or more results,\n"
                              "compared side by side.",
                              report_results);
  command
      ->add_option("result", report.paths,
                   "result.h5 files or their folders; after the first\n"
                   "one also tables of measured curves, mine.csv")
      ->required();
  command
      ->add_option("--label", report.labels,
                   "name of a result in the report; given once for each\n"
                   "result, in their order")
      ->allow_extra_args(false);
  command->add_option("--out", report.out,
                      "output folder (default: that of a single result,\n"
                      "else out/comparison)");
  add_report_forms(command, report.forms);
  add_quiet(command, line.output);
  add_json(command, line.output, "the summaries");
  add_example(command, "report out/polymer --figures pdf --width 86mm");
}

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
  add_run(line);
  add_bench(line);
  add_report(line);
  add_part_commands(line);
  add_check(line);
  add_certify(line);
  add_answer_commands(line);
  add_surface(line);
  add_cache(line);
  add_robustness(line);
  add_small_commands(line);
  add_inspect_commands(line);
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

/// A name that no file can have is a mistake of the user.
run::ExitCode exit_of(const std::error_code& error) {
  return error == std::errc::filename_too_long ||
                 error == std::errc::too_many_symbolic_link_levels
             ? run::exit_bad_input
             : run::exit_internal;
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
  } catch (const asperity::UnusableFolder& error) {
    complain(error.what());
  } catch (const asperity::input::InputError& error) {
    complain(error.what());
  } catch (const std::domain_error& error) {
    complain(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    complain(fmt::format("asperity: {}: {}", error.path1().string(),
                         error.code().message()));
    return asperity::cli::exit_of(error.code());
  } catch (const std::exception& error) {
    complain(fmt::format("asperity: {}", error.what()));
    asperity::run::end_at_once_of_several(asperity::run::exit_internal);
    return asperity::run::exit_internal;
  }
  return asperity::run::exit_bad_input;
}
