#include "app/cli/commands.hpp"

#include "app/asked/asked_cases.hpp"
#include "app/asked/case_library.hpp"
#include "app/cache/cache.hpp"
#include "app/cli/case_run.hpp"
#include "app/cli/checks.hpp"
#include "app/cli/collection.hpp"
#include "app/cli/part_commands.hpp"
#include "app/cli/sweep_commands.hpp"
#include "app/methods/chosen.hpp"
#include "app/plan/description.hpp"
#include "app/plan/plan.hpp"
#include "app/plan/preparation.hpp"
#include "app/plan/skipped.hpp"
#include "app/run/interrupt.hpp"
#include "app/run/last_run.hpp"
#include "app/run/mpi_world.hpp"
#include "app/run/output.hpp"
#include "app/run/output_folder.hpp"
#include "app/run/result_outputs.hpp"
#include "cases/reader/read_case.hpp"
#include "input/input_error.hpp"
#include "reports/pages/paper_report.hpp"
#include "reports/pages/pdf_page.hpp"
#include "reports/pages/report.hpp"
#include "results/result_reader.hpp"
#include "results/trial_read.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "bench/runs/bench.hpp"
#include "bench/runs/target_run.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

RunOptions options_of(const ReadCase& read, const fs::path& folder,
                      const RunCommand& command, Cache& cache) {
  RunOptions options{folder, command.methods, command.resume, command.threads,
                     read.reference};
  options.is_exact = command.is_exact;
  options.has_report = !command.no_report;
  options.cache = &cache;
  options.ranks = n_mpi_ranks();
  options.ranks_on_machine = n_ranks_on_machine();
  return options;
}

/// Runs a case at the setting chosen for the target error, then verifies the
/// error.
ExitCode run_to_target(const ReadCase& read, const RunCommand& command,
                       const RunOptions& options) {
  if (read.found.file.empty())
    throw input::InputError("--target-error needs a case file: asperity new "
                            "NAME --map FILE writes one");
  cases::Case asked = read.contact_case;
  asked.methods = chosen_methods(asked, options.methods, options.is_exact);
  TargetRun target(asked, read.found.file, read.overrides, options.folder,
                   read_target_error(command.target_error));
  if (!target.is_chosen())
    return exit_not_converged;
  ExitCode end = exit_good;
  do {
    const cases::Case chosen = target.chosen_case();
    end = run_one(chosen, options, {.is_omitted = true});
    if (is_interrupted())
      return end;
    if (target.verify(chosen, options.folder))
      break;
    end = worse(end, exit_expectation_failed);
  } while (target.choose_again());
  target.record(options.folder);
  return command.no_report
             ? end
             : worse(end,
                     print_findings(
                         write_outputs(options.folder, command.has_pdf).summary,
                         options.folder));
}

ExitCode print_plans(const std::vector<Asked>& all, const RunCommand& command,
                     Cache& cache) {
  std::string json;
  for (const Asked& asked : all) {
    if (asked.sweep)
      print_sweep_plan(*asked.sweep, command);
    for (const ReadCase& read : asked.cases) {
      RunOptions options = options_of(read, {}, command, cache);
      if (is_for_ranks(asked, command)) // each works on other parts of the run
        options.ranks = options.ranks_on_machine = 1;
      const Plan plan = make_plan(read.contact_case, options);
      const std::vector<cases::MethodSpec> methods =
          chosen_methods(read.contact_case, options.methods, options.is_exact);
      require_surface(read.contact_case, methods,
                      grid_of_case(read.contact_case, methods));
      fmt::print("{}{}", plan_text(plan, read.contact_case),
                 shared_rows_text(plan));
      json += (json.empty() ? "" : ",\n") + plan_json(plan, read.contact_case);
    }
  }
  if (wants_json())
    emit_answer("[" + json + "]\n");
  return exit_good;
}

ExitCode run_asked(const Asked& asked, const RunCommand& command, Cache& cache,
                   JsonAnswer& answer) {
  if (asked.sweep) {
    const fs::path folder =
        folder_of(asked.sweep->sweep.name, command.out, command.cases.size());
    const ExitCode ended = is_for_ranks(asked, command)
                               ? run_over_ranks(asked, command, folder)
                               : run_asked_sweep(*asked.sweep, command, folder);
    add_answer(answer, asked.sweep->sweep.name, folder, ended);
    return ended;
  }
  if (is_for_ranks(asked, command)) {
    const std::string& name = asked.cases.front().found.name;
    const fs::path folder = folder_of(name, command.out, command.cases.size());
    const ExitCode ended = run_over_ranks(asked, command, folder);
    add_answer(answer, name, folder, ended);
    return ended;
  }
  const bool is_collection = !asked.found.collection.empty();
  const std::size_t n_targets = command.cases.size();
  ExitCode end = exit_good;
  std::vector<RunPart> parts;
  std::optional<OutputFolder> collection_lock;
  if (is_collection) {
    const fs::path folder =
        folder_of(asked.found.collection, command.out, n_targets);
    collection_lock.emplace(folder, "run " + asked.found.collection,
                            report_outputs());
    remove_report(folder); // belongs to the parts of the last run
  }
  for (const ReadCase& read : asked.cases) {
    const fs::path folder =
        is_collection
            ? folder_of(asked.found.collection, command.out, n_targets) /
                  read.found.file.parent_path().filename()
            : folder_of(read.found.name, command.out, n_targets);
    const OutputFolder lock(folder, "run " + read.found.name,
                            run_outputs(read.contact_case),
                            input_files(read.contact_case));
    const RunOptions options = options_of(read, folder, command, cache);
    const ExitCode ended =
        command.target_error.empty()
            ? run_if_needed(read.contact_case, options,
                            {command.no_report, command.has_pdf})
            : run_to_target(read, command, options);
    end = worse(end, ended);
    add_answer(answer, read.found.name, folder, ended);
    parts.push_back({read.found, folder});
    if (is_interrupted())
      break;
  }
  if (is_collection && !command.no_report)
    write_collection_report(
        asked.found, parts,
        folder_of(asked.found.collection, command.out, n_targets),
        command.has_pdf);
  return end;
}

/// Refuses a PDF before anything is computed.
void require_pdf_program() {
  if (reports::pdf_program().empty())
    throw std::domain_error(reports::no_pdf_program);
}

} // namespace

void add_answer(JsonAnswer& answer, const std::string& name,
                const fs::path& folder, ExitCode exit_code) {
  if (!wants_json())
    return;
  if (is_sweep_folder(folder)) {
    add_sweep_answer(answer, folder, exit_code);
    return;
  }
  if (!is_result(folder)) {
    answer.add(name, folder, exit_code, nullptr, "there is no result");
    return;
  }
  const results::Result result =
      results::read_result(folder, results::MapsInFile::large);
  const reports::Summary summary =
      reports::summarize(result, reports::case_of(result));
  answer.add(name, folder, exit_code, &summary);
}

fs::path folder_of(const std::string& name, const std::string& out,
                   std::size_t n_targets) {
  if (out.empty())
    return fs::path("out") / name;
  return n_targets == 1 ? fs::path(out) : fs::path(out) / name;
}

ExitCode run_cases(const RunCommand& command) {
  if (command.has_pdf)
    require_pdf_program();
  std::vector<Asked> all;
  for (const std::string& word : command.cases)
    all.push_back(read_asked_or_sweep(word, command.overrides, command.is_quick,
                                      command.contact_modulus));
  catch_interrupts();
  Cache cache(cache_folder(), command.uses_cache ? cache_size() : 0);
  if (command.is_dry)
    return print_plans(all, command, cache);
  if (!command.part.empty())
    return run_part(all, command, cache);
  JsonAnswer answer("asperity-run");
  ExitCode end = exit_good;
  for (const Asked& asked : all) {
    end = worse(end, run_asked(asked, command, cache, answer));
    if (is_interrupted())
      break;
  }
  answer.print(end);
  return end;
}

ExitCode report_results(const ReportCommand& command) {
  const auto& [paths, out, has_pdf, formats, width] = command;
  const reports::ReportExtras extras{has_pdf,
                                     reports::journal_format(formats, width)};
  if (has_pdf)
    require_pdf_program();
  for (const std::string& path : paths)
    if (is_sweep_folder(path)) {
      if (paths.size() > 1)
        throw input::InputError(path +
                                " is a sweep, whose report is written by "
                                "itself; to compare points, give their "
                                "folders: " +
                                path + "/points/000");
      return report_sweep(path, out, extras);
    }
  std::vector<results::Result> read;
  read.reserve(paths.size());
  for (const std::string& path : paths)
    results::require_readable(path);
  for (const std::string& path : paths)
    read.push_back(results::read_result(path, results::MapsInFile::large));
  const fs::path first = paths.front();
  const fs::path folder = !out.empty()              ? fs::path(out)
                          : paths.size() > 1        ? fs::path("out/comparison")
                          : fs::is_directory(first) ? first
                                                    : first.parent_path() / ".";
  const OutputFolder lock(folder, "report", report_outputs(),
                          {paths.begin(), paths.end()});
  for (const std::string& failure :
       reports::write_report(read, folder, "gnuplot", extras))
    fmt::print(stderr, "figure not drawn: {}\n", failure);
  fmt::print("report: {}\n", (folder / "report.html").string());
  JsonAnswer answer("asperity-report");
  for (const results::Result& result : read)
    add_answer(answer, result.case_name,
               fs::is_directory(result.path)
                   ? fs::path(result.path)
                   : fs::path(result.path).parent_path(),
               exit_good);
  answer.print(exit_good);
  return exit_good;
}

ExitCode run_bench(const BenchCommand& command) {
  const ExitCode end = bench_case(command);
  if (!wants_json() || end == exit_interrupted)
    return end;
  const cases::Case contact_case = cases::read_case(
      find_cases(command.contact_case).cases.front().file.string());
  emit_answer(json_of_file((command.out.empty()
                                ? fs::path("out") / contact_case.name / "bench"
                                : fs::path(command.out)) /
                           "bench.json"));
  return end;
}

} // namespace asperity::app
