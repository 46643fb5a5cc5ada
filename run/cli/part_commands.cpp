#include "run/cli/part_commands.hpp"

#include "base/json.hpp"
#include "input/input_error.hpp"
#include "input/reader/case_hash.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "results/result_reader.hpp"
#include "run/child_run.hpp"
#include "run/cli/case_run.hpp"
#include "run/cli/checks.hpp"
#include "run/cli/sweep_commands.hpp"
#include "run/interrupt.hpp"
#include "run/methods/chosen.hpp"
#include "run/mpi_world.hpp"
#include "run/new_output.hpp"
#include "run/output_folder.hpp"
#include "run/plan/needs.hpp"
#include "run/plan/plan.hpp"
#include "run/run_case.hpp"
#include "run/sweeps/parts.hpp"
#include "run/sweeps/slurm_scripts.hpp"
#include "run/sweeps/sweep_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

/// Memory that a task has at least, for the libraries and the report [B].
constexpr double least_memory = 500e6;

std::string absolute_path(const fs::path& path) {
  return fs::absolute(path).lexically_normal().string();
}

/// The one case or sweep that is divided.
const run::NamedCases& divided(const std::vector<run::NamedCases>& named,
                               const RunCommand& command) {
  if (named.size() != 1 || !named.front().found.collection.empty())
    throw input::InputError(fmt::format(
        "{}: only a single case or sweep is divided into parts; name one case",
        fmt::join(command.cases, " ")));
  return named.front();
}

/// The arguments that run a case or a sweep again into a folder, with all that
/// --quick and other options have set.
std::vector<std::string> run_words(const run::NamedCases& named,
                                   const RunCommand& command,
                                   const fs::path& folder) {
  const run::FoundCase& found =
      named.sweep ? named.sweep->found : named.cases.front().found;
  std::vector<std::string> words = run::words_of_run(
      absolute_path(found.file.empty() ? fs::path(command.cases.front())
                                       : found.file),
      named.sweep ? named.sweep->overrides : named.cases.front().overrides,
      command.methods);
  if (found.file.empty()) // of other cases they are overrides
    for (std::string& word : command.options.words())
      words.push_back(std::move(word));
  words.insert(words.end(), {"--out", folder.string()});
  return words;
}

/// Judges a result only by whether all of its load steps have converged.
run::ExitCode exit_of_steps(const fs::path& folder) {
  return run::all_converged(
             results::read_result(folder, results::MapsInFile::large))
             ? run::exit_good
             : run::exit_not_converged;
}

run::ExitCode merge_case(const fs::path& folder, bool no_report, bool has_pdf) {
  run::merge_realizations(folder);
  if (!no_report)
    return print_findings(run::write_outputs(folder, has_pdf, false), folder);
  return exit_of_steps(folder);
}

/// Returns true if one of the methods is parallel over the ranks itself.
bool has_full_block(const cases::Case& contact_case,
                    const RunCommand& command) {
  return std::ranges::any_of(
      methods::chosen_methods(contact_case, command.methods),
      methods::is_full_block);
}

/// Predicts the memory of the task that computes the largest part, without a
/// cache, at the upper end of the prediction [B].
double memory_of_task(const run::NamedCases& named,
                      const std::vector<std::size_t>& members,
                      const RunCommand& command) {
  run::RunOptions options{
      {}, command.methods, false, std::max(1, command.threads)};
  double most = 0.0;
  if (named.sweep) {
    for (const cases::SweptPoint& point : named.sweep->sweep.points)
      most = std::max(most, run::make_plan(point.contact_case, options).memory);
    most *= std::min(static_cast<double>(options.threads),
                     static_cast<double>(members.size()));
  } else {
    options.realizations = {members.begin(), members.end()};
    most = run::make_plan(named.cases.front().contact_case, options).memory;
  }
  return std::max(run::memory_factor * most, least_memory);
}

/// Refuses before anything is written what a rank would refuse.
void require_runnable(const run::NamedCases& named, const RunCommand& command) {
  const auto require = [&](const cases::Case& contact_case) {
    (void)run::require_runnable(
        contact_case, methods::chosen_methods(contact_case, command.methods));
  };
  for (const run::ReadCase& read : named.cases)
    require(read.contact_case);
  if (named.sweep)
    for (const cases::SweptPoint& point : named.sweep->sweep.points)
      require(point.contact_case);
}

run::ExitCode run_realizations(const run::ReadCase& read,
                               const std::vector<std::size_t>& members,
                               const fs::path& folder,
                               const RunCommand& command,
                               methods::Cache& cache) {
  run::RunOptions options = options_of(read, folder, command, cache);
  options.realizations = {members.begin(), members.end()};
  const cases::Case& contact_case = read.contact_case;
  const run::EarlierRun earlier = run::earlier_run(
      contact_case, methods::chosen_methods(contact_case, options.methods),
      folder, options.realizations);
  // The parts to be joined are of one text, comments included.
  const bool is_same = earlier.case_hash == cases::case_hash(contact_case);
  options.resume = earlier.state == run::RunState::to_resume;
  if (earlier.state == run::RunState::complete && is_same)
    fmt::print("is complete already\n");
  else if (run_one(contact_case, options, {.is_omitted = true}) ==
           run::exit_interrupted)
    return run::exit_interrupted;
  return exit_of_steps(folder);
}

run::ExitCode run_points(const run::NamedSweep& named,
                         const std::vector<std::size_t>& members,
                         const fs::path& folder, const RunCommand& command) {
  run::require_own_outputs(folder, run::outputs_of(named));
  run::SweepRunOptions options = options_of(named, folder, command);
  options.resume = true;
  options.points = members;
  const run::SweepOutcome outcome = run::run_sweep(named.sweep, options);
  return outcome.is_interrupted ? run::exit_interrupted : outcome.worst;
}

} // namespace

run::ExitCode run_part(const std::vector<run::NamedCases>& all,
                       const RunCommand& command, methods::Cache& cache) {
  const run::Part part = run::read_part(command.part);
  const run::NamedCases& named = divided(all, command);
  const std::vector<std::size_t> members = run::members_of(named, part);
  const std::string name = run::output_name(named);
  const fs::path folder = folder_of(name, command.out, 1);
  const fs::path own = folder / run::part_folder(part);
  const run::OutputFolder lock(
      own, fmt::format("run {} --part {}", name, command.part),
      run::result_outputs());
  fmt::print("{}, part {} of {}: {} {}\n", name, part.number, part.count,
             named.sweep ? "points" : "realisations", fmt::join(members, ", "));
  const run::ExitCode end =
      named.sweep
          ? run_points(*named.sweep, members, folder, command)
          : run_realizations(named.cases.front(), members, own, command, cache);
  if (end == run::exit_interrupted)
    fmt::print("interrupted; the same command continues\n");
  run::JsonAnswer answer("asperity-run");
  answer.add(name, folder, end, nullptr,
             fmt::format("part {} only; asperity merge joins the parts",
                         command.part));
  answer.print(end);
  return end;
}

bool is_for_ranks(const run::NamedCases& named, const RunCommand& command) {
  if (!command.target_error.empty() || !named.found.collection.empty() ||
      run::n_mpi_ranks() == 1)
    return false;
  if (!named.sweep)
    return named.cases.front().contact_case.surface.realizations > 1 &&
           !has_full_block(named.cases.front().contact_case, command);
  const std::vector<cases::SweptPoint>& points = named.sweep->sweep.points;
  return points.size() > 1 &&
         std::ranges::none_of(points, [&](const cases::SweptPoint& point) {
           return has_full_block(point.contact_case, command);
         });
}

run::ExitCode run_over_ranks(const run::NamedCases& named,
                             const RunCommand& command,
                             const fs::path& folder) {
  require_runnable(named, command);
  const std::size_t n_members = run::n_members(named);
  const int n_parts = std::min(static_cast<int>(n_members), run::n_mpi_ranks());
  const std::string name = run::output_name(named);
  const run::OutputFolder lock(folder, "run " + name,
                               named.sweep ? run::outputs_of(*named.sweep)
                                           : run::result_outputs());
  std::optional<run::NewOutput> output; // of a sweep; a case has its parts
  if (named.sweep) {
    output.emplace(folder, command.resume, reports::sweep_file);
    run::write_record(run::record_of(named.sweep->sweep), output->place());
    run::write_made_case(*named.sweep);
  } else if (!command.resume)
    run::remove_parts(folder);
  const fs::path place = output ? output->place() : folder;
  run::RankedRun run{run_words(named, command, absolute_path(place)), {}, {}};
  run.words.insert(run.words.end(),
                   {"--threads", std::to_string(std::max(1, command.threads))});
  if (!command.uses_cache)
    run.words.emplace_back("--no-cache");
  run.words.emplace_back("--part");
  for (run::Part part{1, n_parts}; part.number <= n_parts; ++part.number) {
    run.last_words.push_back(run::part_text(part));
    run.logs.emplace_back(absolute_path(place / run::part_folder(part)) +
                          "/log.txt");
  }
  fmt::print("{}: {} {} on {} ranks, which write {}\n", name, n_members,
             named.sweep ? "points" : "realisations", n_parts,
             (place / "parts/*/log.txt").string());
  run::run_on_ranks(run);
  if (!output)
    return merge_case(folder, command.no_report, command.has_pdf);
  const run::ExitCode end =
      merge_sweep(place, command.no_report, command.has_pdf);
  output->replace();
  return end;
}

namespace {

struct MergeCommand {
  std::string folder; ///< of the run, with its parts
  bool no_report = false;
  bool has_pdf = false; ///< also print the report
};

/// Joins the parts of a run and writes its report.
/// @throws input::InputError  there are none, or they lack something
run::ExitCode merge_parts(const MergeCommand& command) {
  const fs::path folder = command.folder;
  if (!fs::is_directory(folder))
    throw input::InputError(folder.string() + ": there is no such folder");
  const run::OutputFolder lock(folder, "merge", run::sweep_outputs());
  const bool is_sweep = !run::has_parts_of_case(folder) &&
                        fs::exists(folder / reports::sweep_file);
  const run::ExitCode end =
      is_sweep ? merge_sweep(folder, command.no_report, command.has_pdf)
               : merge_case(folder, command.no_report, command.has_pdf);
  run::JsonAnswer answer("asperity-merge");
  add_answer(
      answer,
      is_sweep
          ? reports::read_sweep_record(folder).case_name
          : results::read_result(folder, results::MapsInFile::large).case_name,
      folder, end);
  answer.print(end);
  return end;
}

struct PlanCommand {
  RunCommand run; ///< of which nothing is run
  bool is_for_slurm = false;
  int n_parts = 0;       ///< 0: one per realisation or point
  std::string time = {}; ///< limit of a task; empty: that of the partition
};

/// Prints the plan of a run, or writes the scripts by which Slurm computes it.
/// @throws input::InputError  as run_part() and write_slurm_scripts(); a wrong
///                            time
run::ExitCode plan_run(const PlanCommand& command) {
  if (!command.is_for_slurm) {
    RunCommand run = command.run;
    run.is_dry = true;
    return run_cases(run);
  }
  const RunCommand& run = command.run;
  if (!command.time.empty())
    run::require_slurm_time(command.time);
  const std::vector<run::NamedCases> all = read_asked(run);
  const run::NamedCases& named = divided(all, run);
  const int n_parts = command.n_parts > 0
                          ? command.n_parts
                          : static_cast<int>(run::n_members(named));
  const std::vector<std::size_t> largest = run::members_of(named, {1, n_parts});
  const std::string name = run::output_name(named);
  const fs::path folder = absolute_path(folder_of(name, run.out, 1));
  const int threads = std::max(1, run.threads);
  const std::map<std::string, std::string> scripts =
      run::slurm_scripts({name, run_words(named, run, folder), n_parts,
                          fs::read_symlink("/proc/self/exe"), folder, threads,
                          command.time, memory_of_task(named, largest, run)});
  if (named.sweep)
    run::require_own_outputs(folder, {reports::maps_file});
  run::write_slurm_scripts(scripts, folder);
  if (named.sweep)
    run::write_made_case(*named.sweep);
  const std::string submit = (folder / "slurm/submit.sh").string();
  fmt::print("{}: {} parts, each of {} thread{}; submit them with\n  sh {}\n",
             name, n_parts, threads, threads == 1 ? "" : "s",
             run::quoted_word(submit));
  if (run::wants_json())
    run::emit_answer(
        text_of_json(nlohmann::ordered_json{{"format", "asperity-plan-slurm"},
                                            {"format_version", 1},
                                            {"case", name},
                                            {"parts", n_parts},
                                            {"threads", threads},
                                            {"time", command.time},
                                            {"submit", submit}},
                     2) +
        "\n");
  return run::exit_good;
}

void add_plan(CommandLine& line) {
  auto [command, plan] =
      line.add<PlanCommand>("plan",
                            "Print what a run needs, or write the scripts\n"
                            "that run it by Slurm; compute nothing.",
                            plan_run);
  RunCommand& run = plan.run;
  command
      ->add_option("case", run.cases,
                   "case file, its folder, shipped case or\n"
                   "collection, measured map or folder of maps")
      ->required();
  CLI::Option* slurm =
      command->add_flag("--slurm", plan.is_for_slurm,
                        "write an array of tasks, their merge and the script\n"
                        "that submits them, into the folder slurm of the\n"
                        "output folder");
  command
      ->add_option("--parts", plan.n_parts,
                   "number of tasks (default: one per realisation or\n"
                   "point)")
      ->check(CLI::Range(1, 1000))
      ->needs(slurm);
  command
      ->add_option("--time", plan.time,
                   "time limit of a task, as for sbatch (default: that of\n"
                   "the partition)")
      ->needs(slurm);
  add_methods(command, run.methods.names);
  command->add_flag("--exactly", run.methods.is_exact,
                    "--methods gives full names only");
  add_case_options(command, run.options);
  add_overrides(command, run.overrides);
  command->add_option("--out", run.out,
                      "output folder of the run (default: out/<case>)");
  add_quick(command, run.is_quick);
  command
      ->add_option("--threads", run.threads,
                   "number of threads (default: all cores; of a task\n"
                   "of Slurm: 1)")
      ->check(CLI::Range(1, 1024));
  add_quiet(command, line.output);
  add_json(command, line.output, "the plans");
  add_example(command, "plan polymer --slurm --parts 4 --time 1:00:00");
}

} // namespace

void add_part_commands(CommandLine& line) {
  add_plan(line);
  auto [merge, options] =
      line.add<MergeCommand>("merge",
                             "Join the parts of a run (run --part) to the\n"
                             "result of the whole, and write its report.",
                             merge_parts);
  merge->add_option("folder", options.folder, "output folder of the run")
      ->required();
  merge->add_flag("--no-report", options.no_report, "join the results only");
  merge->add_flag("--pdf", options.has_pdf,
                  "also print the report to report.pdf, by chromium\n"
                  "or weasyprint");
  add_quiet(merge, line.output);
  add_json(merge, line.output, "the summaries");
  add_example(merge, "merge out/polymer");
}

} // namespace asperity::cli
