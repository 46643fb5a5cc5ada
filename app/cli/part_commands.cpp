#include "app/cli/part_commands.hpp"

#include "app/cli/checks.hpp"
#include "app/cli/sweep_commands.hpp"
#include "app/methods/chosen.hpp"
#include "app/parts/merge.hpp"
#include "app/parts/part_run.hpp"
#include "app/parts/slurm_scripts.hpp"
#include "app/parts/task_needs.hpp"
#include "app/run/interrupt.hpp"
#include "app/run/last_run.hpp"
#include "app/run/mpi_world.hpp"
#include "app/run/output_folder.hpp"
#include "app/sweeps/earlier_run.hpp"
#include "app/sweeps/sweep_run.hpp"
#include "base/json.hpp"
#include "input/input_error.hpp"
#include "results/result_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

/// Time that a task of Slurm has beyond the prediction of its computation, for
/// its start, slow file systems and the report [s].
constexpr double start_allowance = 600.0;

/// Memory that a task has at least, for the libraries and the report [B].
constexpr double least_memory = 500e6;

std::string absolute_path(const fs::path& path) {
  return fs::absolute(path).lexically_normal().string();
}

ExitCode merge_into(const fs::path& folder, const WholeRun& run, bool no_report,
                    bool has_pdf) {
  if (run.asked.sweep)
    return merge_asked_sweep(*run.asked.sweep, folder, no_report, has_pdf);
  merge_realizations(run, folder);
  if (!no_report)
    return print_findings(write_outputs(folder, has_pdf).summary, folder);
  return all_converged(results::read_result(folder, results::MapsInFile::large))
             ? exit_good
             : exit_not_converged;
}

/// Returns true if one of the methods is parallel over the ranks itself.
bool has_full_block(const cases::Case& contact_case,
                    const RunCommand& command) {
  const std::vector<cases::MethodSpec> methods =
      chosen_methods(contact_case, command.methods, command.is_exact);
  return std::ranges::any_of(methods, is_full_block);
}

/// Removes what an earlier run has left for one that does not resume it.
void clear_for_ranks(const fs::path& folder, bool is_sweep) {
  put_last_run_aside(folder);
  std::error_code ignored;
  for (const auto& part : fs::directory_iterator(folder / "parts", ignored))
    if (fs::exists(part.path() / "part.json"))
      fs::remove_all(part.path());
  fs::remove(folder / "parts", ignored); // fails if files of others are there
  if (is_sweep)
    put_points_aside(folder);
}

void add_plan(CLI::App& program, PlanCommand& plan, OutputOptions& output,
              Action& action) {
  CLI::App* command = program.add_subcommand(
      "plan", "Print the predicted cost of a run, or write\n"
              "the scripts that run it by Slurm; compute\n"
              "nothing.");
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
                   "time limit of a task, as for sbatch (default: by\n"
                   "the prediction)")
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

PartRequest part_request(const std::vector<Asked>& asked,
                         const RunCommand& command) {
  if (asked.size() != 1 || !asked.front().found.collection.empty())
    throw input::InputError(fmt::format(
        "{}: only a single case or sweep is divided into parts; name one case",
        fmt::join(command.cases, " ")));
  const Asked& one = asked.front();
  PartRequest request{.methods = command.methods, .is_exact = command.is_exact};
  if (one.sweep) {
    request.case_file = absolute_path(one.sweep->found.file);
    request.overrides = one.sweep->overrides;
    return request;
  }
  const ReadCase& read = one.cases.front();
  const bool is_map = read.found.file.empty();
  request.case_file =
      absolute_path(is_map ? fs::path(command.cases.front()) : read.found.file);
  request.overrides = read.overrides;
  request.contact_modulus = command.contact_modulus;
  return request;
}

ExitCode run_part(const std::vector<Asked>& asked, const RunCommand& command,
                  Cache& cache) {
  const Part part = read_part(command.part);
  const std::vector<PartRecord> records =
      part_records(asked.front(), part_request(asked, command), part.count);
  const PartRecord& record = records[static_cast<std::size_t>(part.number) - 1];
  const fs::path folder = folder_of(record.case_name, command.out, 1);
  const fs::path own = folder / part_folder(part);
  const OutputFolder lock(
      own, fmt::format("run {} --part {}", record.case_name, command.part),
      result_outputs());
  write_part_record(record, folder);
  fmt::print("{}, part {} of {}: {} {}\n", record.case_name, part.number,
             part.count, record.is_sweep ? "points" : "realisations",
             fmt::join(record.members, ", "));
  RunOptions options{own, command.methods, true, command.threads};
  options.is_exact = command.is_exact;
  options.cache = &cache;
  const ExitCode end =
      record.is_sweep
          ? run_part_of_sweep(*asked.front().sweep, record, folder, options)
          : run_part_of_case(asked.front().cases.front(), record, options);
  if (end == exit_interrupted)
    fmt::print("interrupted; the same command continues\n");
  JsonAnswer answer("asperity-run");
  answer.add(record.case_name, folder, end, nullptr,
             fmt::format("part {} only; asperity merge joins the parts",
                         command.part));
  answer.print(end);
  return end;
}

bool is_for_ranks(const Asked& asked, const RunCommand& command) {
  if (!command.target_error.empty() || !asked.found.collection.empty() ||
      n_mpi_ranks() == 1)
    return false;
  if (!asked.sweep)
    return asked.cases.front().contact_case.surface.realizations > 1 &&
           !has_full_block(asked.cases.front().contact_case, command);
  const std::vector<cases::SweptPoint>& points = asked.sweep->sweep.points;
  return points.size() > 1 &&
         std::ranges::none_of(points, [&](const cases::SweptPoint& point) {
           return has_full_block(point.contact_case, command);
         });
}

ExitCode run_over_ranks(const Asked& asked, const RunCommand& command,
                        const fs::path& folder) {
  const PartRequest request = part_request({asked}, command);
  const auto n_members =
      static_cast<int>(part_records(asked, request, 0).size());
  const std::vector<PartRecord> records =
      part_records(asked, request, std::min(n_members, n_mpi_ranks()));
  const OutputFolder lock(folder, "run " + records.front().case_name,
                          asked.sweep ? sweep_outputs() : result_outputs());
  if (!command.resume)
    clear_for_ranks(folder, asked.sweep.has_value());
  RankedRun run{run_words(records.front(), absolute_path(folder)), {}, {}};
  run.words.insert(run.words.end(),
                   {"--threads", std::to_string(std::max(1, command.threads))});
  if (!command.uses_cache)
    run.words.emplace_back("--no-cache");
  run.words.emplace_back("--part");
  for (const PartRecord& record : records) {
    run.last_words.push_back(part_text(record.part));
    run.logs.emplace_back(absolute_path(folder / part_folder(record.part)) +
                          "/log.txt");
  }
  fmt::print("{}: {} {} on {} ranks, which write {}\n",
             records.front().case_name, n_members,
             asked.sweep ? "points" : "realisations", records.size(),
             (folder / "parts/*/log.txt").string());
  run_on_ranks(run);
  return merge_into(folder, read_whole_run(folder), command.no_report,
                    command.has_pdf);
}

ExitCode merge_parts(const MergeCommand& command) {
  const fs::path folder = command.folder;
  if (!fs::is_directory(folder))
    throw input::InputError(folder.string() + ": there is no such folder");
  const OutputFolder lock(folder, "merge", sweep_outputs());
  const WholeRun run = read_whole_run(folder);
  fmt::print("{}: {} parts\n", run.parts.front().case_name, run.parts.size());
  const ExitCode end =
      merge_into(folder, run, command.no_report, command.has_pdf);
  JsonAnswer answer("asperity-merge");
  add_answer(answer, run.parts.front().case_name, folder, end);
  answer.print(end);
  return end;
}

ExitCode plan_run(const PlanCommand& command) {
  if (!command.is_for_slurm) {
    RunCommand run = command.run;
    run.is_dry = true;
    return run_cases(run);
  }
  const RunCommand& run = command.run;
  if (!command.time.empty())
    require_slurm_time(command.time);
  std::vector<Asked> asked;
  for (const std::string& word : run.cases)
    asked.push_back(read_asked_or_sweep(word, run.overrides, run.is_quick,
                                        run.contact_modulus));
  const PartRequest request = part_request(asked, run);
  const std::vector<PartRecord> records =
      part_records(asked.front(), request, command.n_parts);
  const std::string& name = records.front().case_name;
  const fs::path folder = absolute_path(folder_of(name, run.out, 1));
  const int threads = std::max(1, run.threads);
  const TaskNeeds needs = task_needs(asked.front(), records, threads);
  SlurmJob job{
      records.front(), fs::read_symlink("/proc/self/exe"),  folder, threads,
      command.time,    std::max(needs.memory, least_memory)}; // NaN: stays NaN
  if (job.time.empty() && !std::isfinite(needs.time))
    throw input::InputError(
        name + ": its time cannot be predicted; please give --time");
  if (job.time.empty())
    job.time = slurm_time(needs.time + start_allowance);
  write_slurm_scripts(slurm_scripts(job), folder);
  fmt::print("{}: {} parts, each of {} thread{} for at most {}; submit them "
             "with\n  sh {}\n",
             name, records.size(), threads, threads == 1 ? "" : "s", job.time,
             quoted_word((folder / "slurm/submit.sh").string()));
  if (wants_json())
    emit_answer(text_of_json(
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
  return exit_good;
}

void add_part_commands(CLI::App& program, PartCommands& commands,
                       OutputOptions& output, Action& action) {
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

} // namespace asperity::app
