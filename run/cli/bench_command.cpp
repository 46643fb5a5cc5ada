// `asperity bench`: the cost and the error of each setting of a case.
#include "input/reader/read_case.hpp"
#include "run/arguments/case_library.hpp"
#include "run/cli/command_line.hpp"
#include "run/output.hpp"
#include "run/result_outputs.hpp"
#include "suite/bench/runs/bench.hpp"

#include <filesystem>

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

/// Runs bench_case() and prints bench.json if the command has --json.
run::ExitCode run_bench(const bench::BenchCommand& command) {
  const run::ExitCode end = bench::bench_case(command);
  if (!run::wants_json() || end == run::exit_interrupted)
    return end;
  const cases::Case contact_case = cases::read_case(
      run::find_cases(command.contact_case).cases.front().file.string());
  run::emit_answer(run::json_of_file(
      (command.out.empty() ? fs::path("out") / contact_case.name / "bench"
                           : fs::path(command.out)) /
      "bench.json"));
  return end;
}

} // namespace

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
  line.on_cases.insert("bench");
  add_example(command, "bench hertz --target-error 1%");
}

} // namespace asperity::cli
