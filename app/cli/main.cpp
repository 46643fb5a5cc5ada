// The command line of the program: maps arguments to commands and failures to
// exit codes.
#include "app/cli/commands.hpp"
#include "app/cli/robustness_command.hpp"
#include "app/run/mpi_world.hpp"
#include "base/folder_lock.hpp"
#include "base/freed_memory.hpp"
#include "cases/text/case_error.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>
#include <system_error>

#include "bench/runs/bench.hpp"

namespace asperity::app {
namespace {

/// The chosen command, which is called after the command line is parsed.
using Action = std::function<ExitCode()>;

void add_run(CLI::App& program, RunCommand& run, Action& action) {
  CLI::App* command = program.add_subcommand(
      "run", "run cases and write result, tables and report of each");
  command
      ->add_option("case", run.cases,
                   "case file, folder, shipped case or collection")
      ->required();
  command
      ->add_option("--methods", run.methods,
                   "only these, by name or kind: fem,theory")
      ->delimiter(',');
  command
      ->add_option("--set", run.overrides,
                   "key=value over the case file, e.g. surface.points=128")
      ->allow_extra_args(false);
  command->add_option("--out", run.out, "folder (default: out/<case>)");
  command->add_flag("--resume", run.resume,
                    "go on with the steps an earlier run left out");
  command->add_flag("--quick", run.is_quick,
                    "lay the case's quick.set over it: minutes, not precision");
  command->add_option("--target-error", run.target_error,
                      "the cheapest setting predicted to err by less, e.g. "
                      "1%, verified by a finer run");
  command->add_flag("--exactly", run.is_exact,
                    "--methods are names alone: fem is not fem.hard");
  command->add_flag("--no-report", run.no_report, "write result.h5 alone");
  command->add_flag("--dry-run", run.is_dry,
                    "print what would be done, how long it would take and what "
                    "is skipped; write nothing");
  command->add_flag("!--no-cache", run.uses_cache,
                    "compute everything, keep nothing");
  command->add_option("--threads", run.threads, "default: all cores")
      ->check(CLI::Range(1, 1024));
  command->callback([&] { action = [&] { return run_cases(run); }; });
}

void add_bench(CLI::App& program, BenchCommand& bench, Action& action) {
  CLI::App* command = program.add_subcommand(
      "bench", "what each setting of a case's methods costs and how far its "
               "answer is from the truth");
  command
      ->add_option("case", bench.contact_case,
                   "case file, folder, shipped case")
      ->required();
  command
      ->add_option("--methods", bench.methods,
                   "only these, by name or kind: fem,theory")
      ->delimiter(',');
  command
      ->add_option("--set", bench.overrides,
                   "key=value over the case file, e.g. surface.points=128")
      ->allow_extra_args(false);
  command->add_option("--out", bench.out, "folder (default: out/<case>/bench)");
  command
      ->add_option("--repeats", bench.repeats,
                   "timed runs of a setting, after one that warms up")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_option("--realizations", bench.realizations, "at most so many")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--budget", bench.budget,
                   "seconds, after which settings are run once and those but "
                   "the points are left out")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_flag("--quick", bench.is_quick,
                    "quick.set, points alone, one timed run, a minute");
  command->add_option("--target-error", bench.target_error,
                      "also choose the cheapest setting for it: 1%");
  command->callback([&] { action = [&] { return bench_case(bench); }; });
}

void add_report(CLI::App& program, std::vector<std::string>& results,
                std::string& out, Action& action) {
  CLI::App* command = program.add_subcommand(
      "report", "write the report of results, several beside each other");
  command->add_option("result", results, "result.h5 or its folder")->required();
  command->add_option("--out", out,
                      "folder (default: that of a single result, else "
                      "out/comparison)");
  command->callback(
      [&] { action = [&] { return report_results(results, out); }; });
}

void add_check(CLI::App& program, std::vector<std::string>& targets,
               std::string& junit, bool& uses_cache, Action& action) {
  CLI::App* command = program.add_subcommand(
      "check", "hold results against the case's expectations; exit 1 if one "
               "falls out");
  command
      ->add_option("target", targets,
                   "result (file or folder), or a case to run")
      ->required();
  command->add_option("--junit", junit, "file for JUnit XML");
  command->add_flag("!--no-cache", uses_cache,
                    "compute everything, keep nothing");
  command->callback([&] {
    action = [&] { return check_targets(targets, junit, uses_cache); };
  });
}

void add_cache(CLI::App& program, bool& is_to_clear, Action& action) {
  CLI::App* command = program.add_subcommand(
      "cache", "where earlier steps are kept, and how many");
  command->add_flag("--clear", is_to_clear, "remove them all");
  command->callback([&] { action = [&] { return show_cache(is_to_clear); }; });
}

void add_robustness(CLI::App& program, RobustnessCommand& robustness,
                    Action& action) {
  CLI::App* command = program.add_subcommand(
      "robustness",
      "run thousands of random scenes and check every answer; exit 3 "
      "if one is neither verified nor refused");
  command->alias("stress"); // former name of the command
  command->add_option("case", robustness.cases,
                      "cases whose settings are perturbed (default: none)");
  command->add_option("--scenes", robustness.scenes, "how many (default: 2000)")
      ->check(CLI::Range(1, 10000000));
  command->add_option("--seed", robustness.seed, "default: 1");
  command->add_option("--only", robustness.only,
                      "only scenes of a family or of an axis' value: slab, "
                      "law=hard");
  command->add_option("--scene", robustness.scene,
                      "this scene of the seed alone, with all about it");
  command->add_option("--out", robustness.out,
                      "folder (default: out/robustness)");
  command->add_option("--threads", robustness.threads, "default: all cores")
      ->check(CLI::Range(1, 1024));
  command->callback(
      [&] { action = [&] { return run_robustness(robustness); }; });
}

void add_small_commands(CLI::App& program, std::string& name, Action& action) {
  program.add_subcommand("list", "the shipped cases")->callback([&] {
    action = list_cases;
  });
  program.add_subcommand("schema", "JSON Schema of a case file")->callback([&] {
    action = print_schema;
  });
  CLI::App* command =
      program.add_subcommand("new", "write a commented case to start from");
  command->add_option("name", name, "folder to make")->required();
  command->callback([&] { action = [&] { return new_case(name); }; });
}

int run(int argc, char** argv) {
  CLI::App program(
      "Asperity: rough contact by finite elements, half-space and Persson's "
      "theory,\nfrom one case file, side by side in one report");
  program.name("asperity");
  program.require_subcommand(1);
  program.set_version_flag("--version", ASPERITY_VERSION);
  program.footer("exit codes: 0 good, 1 an expectation failed, 2 bad input, "
                 "3 a solution did not\nconverge, 4 system or library error, "
                 "130 interrupted");
  Action action;
  RunCommand run;
  RobustnessCommand stress;
  std::vector<std::string> paths;
  std::string out;
  add_run(program, run, action);
  BenchCommand bench;
  add_bench(program, bench, action);
  add_report(program, paths, out, action);
  add_check(program, paths, out, run.uses_cache, action);
  bool is_to_clear = false;
  add_cache(program, is_to_clear, action);
  add_robustness(program, stress, action);
  add_small_commands(program, out, action);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? exit_good : exit_bad_input;
  }
  return action();
}

} // namespace
} // namespace asperity::app

int main(int argc, char** argv) {
  asperity::keep_freed_memory();
  std::signal(SIGXFSZ, SIG_IGN); // exceeding a file size limit is an ordinary
                                 // error
  try {
    const int end = asperity::app::has_followed_rank_0()
                        ? asperity::app::exit_good
                        : asperity::app::run(argc, argv);
    if (std::fflush(stdout) != 0)
      throw std::system_error(errno, std::generic_category(),
                              "cannot write standard output");
    return end;
  } catch (const asperity::FolderInUse& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const asperity::cases::CaseError& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::domain_error& error) {
    fmt::print(stderr, "{}\n", error.what());
  } catch (const std::exception& error) {
    fmt::print(stderr, "asperity: {}\n", error.what());
    return asperity::app::exit_internal;
  }
  return asperity::app::exit_bad_input;
}
