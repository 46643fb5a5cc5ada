// `asperity robustness`: runs and verifies the random problem instances of the
// stability matrix and writes the reports.

#include "base/atomic_file.hpp"
#include "input/input_error.hpp"
#include "input/reader/read_case.hpp"
#include "results/provenance.hpp"
#include "run/arguments/case_library.hpp"
#include "run/cli/command_line.hpp"
#include "run/interrupt.hpp"
#include "run/mpi_world.hpp"
#include "run/output.hpp"
#include "run/output_folder.hpp"
#include "run/progress.hpp"
#include "suite/robustness/instance_pool.hpp"
#include "suite/robustness/matrix.hpp"
#include "suite/robustness/run_instance.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;
using robustness::Instance;

struct RobustnessCommand {
  std::vector<std::string> cases; ///< cases to perturb; none: random
  int instances = 2000; ///< number of instances that match `only`, per case
  std::uint64_t seed = 1;
  int first = 0;               ///< index of the first instance
  std::string only;            ///< see robustness::InstanceFilter
  std::optional<int> instance; ///< run only this instance and print all details
  int threads = 0;             ///< number of processes; 0: all cores
  std::string out = "out/robustness";
};

/// Where the problem instances come from: a base case, or none.
struct Source {
  std::string name; ///< name of the case; empty: none
  std::string word; ///< path of the case file, as needed to repeat the run
  std::vector<robustness::Base> bases = {}; ///< taken in turn

  Instance draw(std::uint64_t seed, int index) const {
    const auto n = static_cast<int>(bases.size());
    return robustness::draw_instance(
        seed, index,
        n == 0 ? nullptr : &bases[static_cast<std::size_t>(index % n)]);
  }
};

std::vector<Source> sources_of(const RobustnessCommand& command) {
  std::vector<Source> sources;
  for (const std::string& word : command.cases)
    for (const run::FoundCase& found : run::find_cases(word).cases) {
      const cases::Case read = cases::read_case(found.file.string());
      sources.push_back({found.name.empty() ? read.name : found.name,
                         found.file.string(), robustness::bases_of(read)});
    }
  if (command.cases.empty())
    sources.emplace_back();
  return sources;
}

/// The requested instances: the first ones of the seed from `first` on that
/// match the filter.
robustness::InstanceSequence instances_of(const Source& source,
                                          const RobustnessCommand& command) {
  return {[&source, seed = command.seed](int index) {
            return source.draw(seed, index);
          },
          robustness::InstanceFilter(command.only), command.first,
          static_cast<std::size_t>(command.instances)};
}

std::string rerun_of(const Source& source, const RobustnessCommand& command) {
  return fmt::format("asperity robustness{}{} --seed {}",
                     source.word.empty() ? "" : " ", source.word, command.seed);
}

std::string fact(const results::Provenance& facts, const std::string& name) {
  for (const auto& [key, value] : facts)
    if (key == name)
      return value;
  return "unknown";
}

using Results = std::map<int, robustness::InstanceResult>;

void write_table(const fs::path& folder, const Results& results) {
  std::string csv = robustness::csv_header();
  for (const auto& [index, result] : results)
    csv += robustness::csv_line(result);
  write_file_atomically(folder / "stress.csv", csv);
}

/// Runs all instances. Reports arrive in any order and are sorted by index.
/// Every ten seconds the table of those that have ended is written.
Results results_of(robustness::InstanceSequence& instances,
                   const RobustnessCommand& command, const fs::path& folder) {
  Results results;
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  auto last_line = begin;
  std::fflush(stdout); // otherwise a child process would print it again
  robustness::run_instances(
      instances, {command.threads, 60.0, run::is_interrupted},
      [&](const Instance& instance, const robustness::InstanceReport& report) {
        results[report.index] = {instance, report};
        const auto now = Clock::now();
        if (now - last_line < std::chrono::seconds(10))
          return;
        last_line = now;
        write_table(folder, results);
        fmt::print(
            "{} of {} problem instances, {}\n", results.size(),
            command.instances,
            run::remaining_text(begin, results.size(),
                                static_cast<std::size_t>(command.instances)));
        std::fflush(stdout);
      },
      [](const Instance& instance) {
        return robustness::run_instance(instance);
      });
  return results;
}

/// The command for what an interrupted run has left: the instances from the
/// first one on that has not ended, some of which may have.
std::string rest_of(robustness::InstanceSequence& instances,
                    const Results& results, const Source& source,
                    const RobustnessCommand& command) {
  std::size_t place = 0;
  const Instance* left = instances.at(place);
  while (left != nullptr && results.contains(left->index))
    left = instances.at(++place);
  if (left == nullptr)
    return "nothing is left";
  return fmt::format(
      "continue with {}{} --first {} --instances {} --out {}-rest",
      rerun_of(source, command),
      command.only.empty() ? "" : " --only " + command.only, left->index,
      command.instances - static_cast<int>(place), command.out);
}

run::ExitCode run_source(const Source& source, const RobustnessCommand& command,
                         std::string& json) {
  const auto begin = std::chrono::steady_clock::now();
  robustness::InstanceSequence instances = instances_of(source, command);
  const fs::path folder = fs::path(command.out) / source.name;
  const run::OutputFolder lock(folder, "robustness",
                               {"stress.csv", "stress.json"}, {source.word});
  const Results results = results_of(instances, command, folder);
  robustness::Matrix matrix;
  for (const auto& [index, result] : results)
    matrix.add(result);

  const results::Provenance facts = results::program_facts();
  robustness::RunDescription words;
  words.rerun = rerun_of(source, command);
  words.commit = fact(facts, "commit");
  words.machine =
      fact(facts, "processor") + ", " + fact(facts, "cores") + " cores";
  words.seed = command.seed;
  words.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
          .count();
  write_table(folder, results);
  write_file_atomically(
      folder / "stress.json",
      robustness::json_of(matrix, words, robustness::locking_table()));
  json +=
      (json.empty() ? "" : ",\n") + run::json_of_file(folder / "stress.json");

  fmt::print("{}", text_of(matrix, words));
  const robustness::Counts& total = matrix.total();
  fmt::print("{} problem instances in {:.0f} s: {} verified, {} refused, {} "
             "with any other outcome; {}\n",
             total.all(), words.wall_seconds,
             total.of(robustness::Outcome::verified),
             total.of(robustness::Outcome::refused), total.others(),
             (folder / "stress.json").string());
  if (run::is_interrupted()) {
    fmt::print("interrupted after {} of {} problem instances; {}\n",
               results.size(), command.instances,
               rest_of(instances, results, source, command));
    return run::exit_interrupted;
  }
  return total.others() > 0 ? run::exit_not_converged : run::exit_good;
}

/// Runs a single instance in this process, for use with a debugger, and prints
/// everything known about it.
run::ExitCode run_instance_alone(const Source& source,
                                 const RobustnessCommand& command) {
  const Instance instance = source.draw(command.seed, *command.instance);
  fmt::print("{}\n", text_of(instance));
  const robustness::InstanceReport report = robustness::run_instance(instance);
  fmt::print("{}{}{}{}\n{} iterations, area fraction {:.6g}, mean gap {:.6g} "
             "h_rms, {:.3f} s\n",
             name_of(report.outcome), report.check.empty() ? "" : ": ",
             report.check, report.reason.empty() ? "" : ": " + report.reason,
             report.iterations, report.area, report.reduced_gap,
             report.seconds);
  if (report.has_pair)
    fmt::print(
        "metamorphic pair ({}): {} bits, mean gaps {:.3g} tolerances apart\n",
        instance.label("metamorphic pair"),
        report.has_same_bits ? "identical" : "different",
        report.pair_difference);
  return is_good(report.outcome) ? run::exit_good : run::exit_not_converged;
}

/// Writes stress.json and stress.csv into `out`; for a case, into
/// the sub-folder with the name of the case.
///
/// @return  exit_not_converged if any instance is neither verified nor
///          refused, exit_interrupted after an interrupt
run::ExitCode run_robustness(const RobustnessCommand& command) {
  if (run::n_mpi_ranks() > 1)
    throw input::InputError("asperity robustness distributes its instances "
                            "among processes itself; please start it without "
                            "mpirun");
  if (!command.instance)
    run::catch_interrupts();
  run::ExitCode worst = run::exit_good;
  std::string json; // of each source
  for (const Source& source : sources_of(command)) {
    worst =
        std::max(worst, command.instance ? run_instance_alone(source, command)
                                         : run_source(source, command, json));
    if (run::is_interrupted())
      break;
  }
  if (run::wants_json() && !command.instance)
    run::emit_answer(command.cases.size() > 1 ? "[" + json + "]\n" : json);
  return worst;
}

} // namespace

void add_robustness(CommandLine& line) {
  auto [command, robustness] =
      line.add<RobustnessCommand>("robustness",
                                  "Run thousands of random problem instances\n"
                                  "and verify every answer; exit 3 if one is\n"
                                  "neither verified nor refused.",
                                  run_robustness);
  command->alias("stress"); // former name of the command
  command->add_option("case", robustness.cases,
                      "cases whose settings are perturbed\n"
                      "(default: none)");
  command
      ->add_option("--instances", robustness.instances,
                   "number of problem instances (default: 2000)")
      ->check(CLI::Range(1, 10000000));
  command->add_option("--seed", robustness.seed,
                      "seed of the instances (default: 1)");
  command
      ->add_option("--first", robustness.first,
                   "index of the first instance (default: 0)")
      ->check(CLI::Range(0, 1000000000));
  command->add_option("--only", robustness.only,
                      "only instances of a family or with a value of an\n"
                      "axis: slab, law=hard");
  command->add_option("--instance", robustness.instance,
                      "run the instance with this index only and print\n"
                      "its details");
  command->add_option("--out", robustness.out,
                      "output folder (default: out/robustness)");
  add_threads(command, robustness.threads);
  add_quiet(command, line.output);
  add_json(command, line.output, "stress.json");
  line.on_cases.insert("robustness");
  add_example(command, "robustness --instances 500 --only law=hard");
}

} // namespace asperity::cli
