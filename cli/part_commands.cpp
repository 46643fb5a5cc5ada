#include "cli/part_commands.hpp"

#include "base/json.hpp"
#include "cli/checks.hpp"
#include "cli/sweep_commands.hpp"
#include "input/input_error.hpp"
#include "methods/chosen.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "results/result_reader.hpp"
#include "run/distributed/merge.hpp"
#include "run/distributed/part_run.hpp"
#include "run/distributed/slurm_scripts.hpp"
#include "run/interrupt.hpp"
#include "run/last_run.hpp"
#include "run/mpi_world.hpp"
#include "run/output_folder.hpp"
#include "run/plan/needs.hpp"
#include "run/plan/plan.hpp"
#include "run/run_case.hpp"
#include "run/sweeps/earlier_run.hpp"
#include "run/sweeps/sweep_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

/// Memory that a task has at least, for the libraries and the report [B].
constexpr double least_memory = 500e6;

std::string absolute_path(const fs::path& path) {
  return fs::absolute(path).lexically_normal().string();
}

run::ExitCode merge_into(const fs::path& folder, const run::WholeRun& run,
                         bool no_report, bool has_pdf) {
  if (run.named.sweep)
    return merge_named_sweep(*run.named.sweep, folder, no_report, has_pdf);
  run::merge_realizations(run, folder);
  if (!no_report)
    return print_findings(run::write_outputs(folder, has_pdf).summary, folder);
  return run::all_converged(
             results::read_result(folder, results::MapsInFile::large))
             ? run::exit_good
             : run::exit_not_converged;
}

/// Returns true if one of the methods is parallel over the ranks itself.
bool has_full_block(const cases::Case& contact_case,
                    const RunCommand& command) {
  const std::vector<cases::MethodSpec> methods =
      methods::chosen_methods(contact_case, command.methods, command.is_exact);
  return std::ranges::any_of(methods, methods::is_full_block);
}

/// Predicts the memory of the task that computes the largest part, without a
/// cache, at the upper end of the prediction [B].
double memory_of_task(const run::NamedCases& named,
                      const std::vector<run::PartRecord>& records,
                      const RunCommand& command) {
  run::RunOptions options{
      {}, command.methods, false, std::max(1, command.threads)};
  options.is_exact = command.is_exact;
  double most = 0.0;
  for (const run::PartRecord& record : records) {
    double memory = 0.0;
    if (named.sweep) {
      for (const std::size_t point : record.members)
        memory = std::max(
            memory, run::make_plan(
                        named.sweep->sweep.points[point].contact_case, options)
                        .memory);
      memory *= std::min(static_cast<double>(options.threads),
                         static_cast<double>(record.members.size()));
    } else {
      options.realizations = {record.members.begin(), record.members.end()};
      memory = run::make_plan(named.cases.front().contact_case, options).memory;
    }
    most = std::max(most, memory);
  }
  return std::max(run::memory_factor * most, least_memory);
}

/// Refuses before anything is written what a rank would refuse.
void require_runnable(const run::NamedCases& named, const RunCommand& command) {
  const auto require = [&](const cases::Case& contact_case) {
    (void)run::require_runnable(
        contact_case, methods::chosen_methods(contact_case, command.methods,
                                              command.is_exact));
  };
  for (const run::ReadCase& read : named.cases)
    require(read.contact_case);
  if (named.sweep)
    for (const cases::SweptPoint& point : named.sweep->sweep.points)
      require(point.contact_case);
}

/// Runs a part, whose record is there while it runs, so that others may join
/// it. A part that is refused leaves no record.
run::ExitCode run_recorded(const run::PartRecord& record,
                           const fs::path& folder,
                           const std::function<run::ExitCode()>& work) {
  const bool is_new = run::write_part_record(record, folder);
  const auto remove_record = [&] {
    if (is_new)
      run::remove_part_record(record, folder);
  };
  try {
    return work();
  } catch (const input::InputError&) {
    remove_record();
    throw;
  } catch (const std::domain_error&) {
    remove_record();
    throw;
  }
}

/// Removes what an earlier run has left for one that does not resume it.
void clear_for_ranks(const fs::path& folder, bool is_sweep) {
  run::put_last_run_aside(folder);
  std::error_code ignored;
  for (const auto& part : fs::directory_iterator(folder / "parts", ignored))
    if (fs::exists(part.path() / "part.json"))
      fs::remove_all(part.path());
  fs::remove(folder / "parts", ignored); // fails if files of others are there
  if (is_sweep)
    run::put_points_aside(folder);
}

void add_plan(CLI::App& program, PlanCommand& plan, run::OutputOptions& output,
              Action& action) {
  CLI::App* command = program.add_subcommand(
      "plan", "Print what a run needs, or write the scripts\n"
              "that run it by Slurm; compute nothing.");
  RunCommand& run = plan.run;
  command
      ->add_option("case", run.cases,
                   "case file, its folder, shipped case or\n"
                   "collection, or measured map")
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
  add_methods(command, run.methods);
  command->add_flag("--exactly", run.is_exact,
                    "--methods gives full names only");
  command->add_option("--contact-modulus", run.contact_modulus,
                      "E* of the block under a map file, e.g. \"2 GPa\"");
  add_overrides(command, run.overrides);
  command->add_option("--out", run.out,
                      "output folder of the run (default: out/<case>)");
  add_quick(command, run.is_quick);
  command
      ->add_option("--threads", run.threads,
                   "number of threads (default: all cores; of a task\n"
                   "of Slurm: 1)")
      ->check(CLI::Range(1, 1024));
  add_quiet(command, output);
  add_json(command, output, "the plans");
  add_example(command, "plan polymer --slurm --parts 4 --time 1:00:00");
  command->callback([&] { action = [&] { return plan_run(plan); }; });
}

} // namespace

run::PartRequest part_request(const std::vector<run::NamedCases>& named,
                              const RunCommand& command) {
  if (named.size() != 1 || !named.front().found.collection.empty())
    throw input::InputError(fmt::format(
        "{}: only a single case or sweep is divided into parts; name one case",
        fmt::join(command.cases, " ")));
  const run::NamedCases& one = named.front();
  run::PartRequest request{.methods = command.methods,
                           .is_exact = command.is_exact};
  if (one.sweep) {
    request.case_file = absolute_path(one.sweep->found.file);
    request.overrides = one.sweep->overrides;
    return request;
  }
  const run::ReadCase& read = one.cases.front();
  const bool is_map = read.found.file.empty();
  request.case_file =
      absolute_path(is_map ? fs::path(command.cases.front()) : read.found.file);
  request.overrides = read.overrides;
  request.contact_modulus = command.contact_modulus;
  return request;
}

run::ExitCode run_part(const std::vector<run::NamedCases>& named,
                       const RunCommand& command, methods::Cache& cache) {
  const run::Part part = run::read_part(command.part);
  const std::vector<run::PartRecord> records = run::part_records(
      named.front(), part_request(named, command), part.count);
  const run::PartRecord& record =
      records[static_cast<std::size_t>(part.number) - 1];
  const fs::path folder = folder_of(record.case_name, command.out, 1);
  const fs::path own = folder / run::part_folder(part);
  const run::OutputFolder lock(
      own, fmt::format("run {} --part {}", record.case_name, command.part),
      run::result_outputs());
  if (record.is_sweep && !named.front().sweep->text.empty())
    run::require_own_outputs(folder, {reports::maps_file});
  fmt::print("{}, part {} of {}: {} {}\n", record.case_name, part.number,
             part.count, record.is_sweep ? "points" : "realisations",
             fmt::join(record.members, ", "));
  run::RunOptions options{own, command.methods, true, command.threads};
  options.is_exact = command.is_exact;
  options.cache = &cache;
  options.has_report = !command.no_report;
  const run::ExitCode end = run_recorded(record, folder, [&] {
    return record.is_sweep ? run::run_part_of_sweep(*named.front().sweep,
                                                    record, folder, options)
                           : run::run_part_of_case(named.front().cases.front(),
                                                   record, options);
  });
  if (end == run::exit_interrupted)
    fmt::print("interrupted; the same command continues\n");
  run::JsonAnswer answer("asperity-run");
  answer.add(record.case_name, folder, end, nullptr,
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
  const run::PartRequest request = part_request({named}, command);
  const auto n_members =
      static_cast<int>(run::part_records(named, request, 0).size());
  const std::vector<run::PartRecord> records = run::part_records(
      named, request, std::min(n_members, run::n_mpi_ranks()));
  const run::OutputFolder lock(folder, "run " + records.front().case_name,
                               named.sweep ? run::outputs_of(*named.sweep)
                                           : run::result_outputs());
  if (!command.resume)
    clear_for_ranks(folder, named.sweep.has_value());
  if (named.sweep)
    run::write_made_case(*named.sweep);
  run::RankedRun run{
      run::run_arguments(records.front(), absolute_path(folder)), {}, {}};
  run.words.insert(run.words.end(),
                   {"--threads", std::to_string(std::max(1, command.threads))});
  if (!command.uses_cache)
    run.words.emplace_back("--no-cache");
  run.words.emplace_back("--part");
  for (const run::PartRecord& record : records) {
    run.last_words.push_back(run::part_text(record.part));
    run.logs.emplace_back(
        absolute_path(folder / run::part_folder(record.part)) + "/log.txt");
  }
  fmt::print("{}: {} {} on {} ranks, which write {}\n",
             records.front().case_name, n_members,
             named.sweep ? "points" : "realisations", records.size(),
             (folder / "parts/*/log.txt").string());
  run::run_on_ranks(run);
  return merge_into(folder, run::read_whole_run(folder), command.no_report,
                    command.has_pdf);
}

run::ExitCode merge_parts(const MergeCommand& command) {
  const fs::path folder = command.folder;
  if (!fs::is_directory(folder))
    throw input::InputError(folder.string() + ": there is no such folder");
  const run::OutputFolder lock(folder, "merge", run::sweep_outputs());
  const run::WholeRun run = run::read_whole_run(folder);
  fmt::print("{}: {} parts\n", run.parts.front().case_name, run.parts.size());
  const run::ExitCode end =
      merge_into(folder, run, command.no_report, command.has_pdf);
  run::JsonAnswer answer("asperity-merge");
  add_answer(answer, run.parts.front().case_name, folder, end);
  answer.print(end);
  return end;
}

run::ExitCode plan_run(const PlanCommand& command) {
  if (!command.is_for_slurm) {
    RunCommand run = command.run;
    run.is_dry = true;
    return run_cases(run);
  }
  const RunCommand& run = command.run;
  if (!command.time.empty())
    run::require_slurm_time(command.time);
  const std::vector<run::NamedCases> named = read_asked(run);
  const run::PartRequest request = part_request(named, run);
  const std::vector<run::PartRecord> records =
      run::part_records(named.front(), request, command.n_parts);
  const std::string& name = records.front().case_name;
  const fs::path folder = absolute_path(folder_of(name, run.out, 1));
  const int threads = std::max(1, run.threads);
  const run::SlurmJob job{
      records.front(), fs::read_symlink("/proc/self/exe"),
      folder,          threads,
      command.time,    memory_of_task(named.front(), records, run)};
  const std::map<std::string, std::string> scripts = run::slurm_scripts(job);
  if (named.front().sweep)
    run::require_own_outputs(folder, {reports::maps_file});
  run::write_slurm_scripts(scripts, folder);
  if (named.front().sweep)
    run::write_made_case(*named.front().sweep);
  fmt::print("{}: {} parts, each of {} thread{}; submit them with\n  sh {}\n",
             name, records.size(), threads, threads == 1 ? "" : "s",
             run::quoted_word((folder / "slurm/submit.sh").string()));
  if (run::wants_json())
    run::emit_answer(text_of_json(
                         nlohmann::ordered_json{
                             {"format", "asperity-plan-slurm"},
                             {"format_version", 1},
                             {"case", name},
                             {"parts", records.size()},
                             {"threads", threads},
                             {"time", job.time},
                             {"submit", (folder / "slurm/submit.sh").string()}},
                         2) +
                     "\n");
  return run::exit_good;
}

void add_part_commands(CLI::App& program, PartCommands& commands,
                       run::OutputOptions& output, Action& action) {
  add_plan(program, commands.plan, output, action);
  CLI::App* merge = program.add_subcommand(
      "merge", "Join the parts of a run (run --part) to the\n"
               "result of the whole, and write its report.");
  merge->add_option("folder", commands.merge.folder, "output folder of the run")
      ->required();
  merge->add_flag("--no-report", commands.merge.no_report,
                  "join the results only");
  merge->add_flag("--pdf", commands.merge.has_pdf,
                  "also print the report to report.pdf, by chromium\n"
                  "or weasyprint");
  add_quiet(merge, output);
  add_json(merge, output, "the summaries");
  add_example(merge, "merge out/polymer");
  merge->callback(
      [&] { action = [&] { return merge_parts(commands.merge); }; });
}

} // namespace asperity::cli
