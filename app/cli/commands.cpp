#include "app/cli/commands.hpp"

#include "app/cache/cache.hpp"
#include "app/cli/asked_cases.hpp"
#include "app/cli/checks.hpp"
#include "app/cli/collection.hpp"
#include "app/cli/sweep_commands.hpp"
#include "app/methods/chosen.hpp"
#include "app/plan/plan.hpp"
#include "app/run/case_library.hpp"
#include "app/run/interrupt.hpp"
#include "app/run/last_run.hpp"
#include "app/run/run_case.hpp"
#include "base/atomic_file.hpp"
#include "base/folder_lock.hpp"
#include "cases/text/case_error.hpp"
#include "reports/analysis/warnings.hpp"
#include "reports/pages/paper_report.hpp"
#include "reports/pages/report.hpp"
#include "results/csv.hpp"
#include "results/result_reader.hpp"
#include "results/trial_read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "bench/runs/bench.hpp"
#include "bench/runs/target_run.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

reports::Summary summary_of(const results::Result& result) {
  const cases::Case contact_case = reports::case_of(result);
  fmt::print("{}", reports::warning_lines(result, contact_case));
  return reports::summarize(result, contact_case);
}

/// Writes all output files besides result.h5: table, summary and report.
reports::Summary write_outputs(const fs::path& folder) {
  const results::Result result = results::read_result(folder);
  const cases::Case contact_case = reports::case_of(result);
  reports::ReportEntry entry = reports::entry_of(result, contact_case);
  results::write_curves_csv(result, folder / "curves.csv");
  for (const std::string& failure : reports::write_report({&entry, 1}, folder))
    fmt::print(stderr, "figure not drawn: {}\n", failure);
  fmt::print("{}", reports::warning_lines(result, contact_case));
  return entry.summary;
}

/// Writes the report on a result and prints its findings.
ExitCode report_on(const fs::path& folder) {
  const reports::Summary summary = write_outputs(folder);
  print_verdicts(summary);
  fmt::print("report: {}\n", (folder / "report.html").string());
  return exit_code_of(summary);
}

ExitCode run_one(const cases::Case& contact_case, const RunOptions& options,
                 bool no_report = false) {
  fmt::print("{}: {}\n", contact_case.name, contact_case.title);
  const RunOutcome outcome = run_case(contact_case, options);
  const ExitCode reported = no_report ? exit_good : report_on(options.folder);
  if (outcome.is_interrupted) {
    if (!no_report)
      fmt::print("interrupted; continue with --resume\n");
    return exit_interrupted;
  }
  return no_report && outcome.failed_steps > 0 ? exit_not_converged : reported;
}

/// Returns the output folder of a case or collection of that name.
fs::path folder_of(const std::string& name, const RunCommand& command) {
  if (command.out.empty())
    return fs::path("out") / name;
  return command.cases.size() == 1 ? fs::path(command.out)
                                   : fs::path(command.out) / name;
}

bool is_result(const fs::path& path) {
  return path.extension() == ".h5" || fs::exists(path / "result.h5") ||
         is_sweep_folder(path);
}

RunOptions options_of(const ReadCase& read, const fs::path& folder,
                      const RunCommand& command, Cache& cache) {
  RunOptions options{folder, command.methods, command.resume, command.threads,
                     read.reference};
  options.is_exact = command.is_exact;
  options.cache = &cache;
  return options;
}

/// Runs a case at the setting chosen for the target error, then verifies the
/// error.
ExitCode run_to_target(const ReadCase& read, const RunCommand& command,
                       const RunOptions& options) {
  if (read.found.file.empty())
    throw cases::CaseError("--target-error needs a case file: asperity new "
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
    end = run_one(chosen, options, true);
    if (is_interrupted())
      return end;
    if (target.verify(chosen, options.folder))
      break;
    end = worse(end, exit_expectation_failed);
  } while (target.choose_again());
  target.record(options.folder);
  return command.no_report ? end : worse(end, report_on(options.folder));
}

void print_plans(const Asked& asked, const RunCommand& command, Cache& cache) {
  if (asked.sweep)
    print_sweep_plan(*asked.sweep, command);
  for (const ReadCase& read : asked.cases)
    fmt::print("{}", plan_text(make_plan(read.contact_case,
                                         options_of(read, {}, command, cache)),
                               read.contact_case));
}

ExitCode run_asked(const Asked& asked, const RunCommand& command,
                   Cache& cache) {
  if (asked.sweep)
    return run_asked_sweep(*asked.sweep, command,
                           folder_of(asked.sweep->sweep.name, command));
  const bool is_collection = !asked.found.collection.empty();
  ExitCode end = exit_good;
  std::vector<RunPart> parts;
  std::optional<FolderLock> collection_lock;
  if (is_collection) {
    const fs::path folder = folder_of(asked.found.collection, command);
    collection_lock.emplace(folder, "run " + asked.found.collection);
    remove_report(folder); // belongs to the parts of the last run
  }
  for (const ReadCase& read : asked.cases) {
    const fs::path folder = is_collection
                                ? folder_of(asked.found.collection, command) /
                                      read.found.file.parent_path().filename()
                                : folder_of(read.found.name, command);
    const FolderLock lock(folder, "run " + read.found.name);
    const RunOptions options = options_of(read, folder, command, cache);
    end =
        worse(end, command.target_error.empty()
                       ? run_one(read.contact_case, options, command.no_report)
                       : run_to_target(read, command, options));
    parts.push_back({read.found, folder});
    if (is_interrupted())
      break;
  }
  if (is_collection && !command.no_report)
    write_collection_report(asked.found, parts,
                            folder_of(asked.found.collection, command));
  return end;
}

} // namespace

ExitCode run_cases(const RunCommand& command) {
  std::vector<Asked> all;
  for (const std::string& word : command.cases)
    all.push_back(read_asked_or_sweep(word, command.overrides, command.is_quick,
                                      command.contact_modulus));
  catch_interrupts();
  Cache cache(cache_folder(), command.uses_cache ? cache_size() : 0);
  ExitCode end = exit_good;
  for (const Asked& asked : all) {
    if (command.is_dry) {
      print_plans(asked, command, cache);
      continue;
    }
    end = worse(end, run_asked(asked, command, cache));
    if (is_interrupted())
      break;
  }
  return end;
}

ExitCode report_results(const std::vector<std::string>& paths,
                        const std::string& out) {
  for (const std::string& path : paths)
    if (is_sweep_folder(path)) {
      if (paths.size() > 1)
        throw cases::CaseError(path +
                               " is a sweep, whose report is written by "
                               "itself; to compare points, give their "
                               "folders: " +
                               path + "/points/000");
      return report_sweep(path, out);
    }
  std::vector<results::Result> read;
  read.reserve(paths.size());
  for (const std::string& path : paths)
    results::require_readable(path);
  for (const std::string& path : paths)
    read.push_back(results::read_result(path));
  const fs::path first = paths.front();
  const fs::path folder = !out.empty()              ? fs::path(out)
                          : paths.size() > 1        ? fs::path("out/comparison")
                          : fs::is_directory(first) ? first
                                                    : first.parent_path() / ".";
  const FolderLock lock(folder, "report");
  for (const std::string& failure : reports::write_report(read, folder))
    fmt::print(stderr, "figure not drawn: {}\n", failure);
  fmt::print("report: {}\n", (folder / "report.html").string());
  return exit_good;
}

namespace {

void check_cases(const Asked& asked, bool uses_cache, Cache& cache,
                 Checks& checks) {
  catch_interrupts();
  if (asked.sweep)
    check_asked_sweep(*asked.sweep, uses_cache, checks);
  for (const auto& [found, contact_case, reference, overrides] : asked.cases) {
    const fs::path folder = fs::path("out") / found.name;
    const FolderLock lock(folder, "check " + found.name);
    if (run_case(contact_case, {folder, {}, false, 0, reference, &cache})
            .is_interrupted) {
      checks.add_problem(found.name, "interrupted", exit_interrupted);
      return;
    }
    checks.add(write_outputs(folder));
  }
}

} // namespace

ExitCode check_targets(const std::vector<std::string>& targets,
                       const std::string& junit, bool uses_cache) {
  Cache cache(cache_folder(), uses_cache ? cache_size() : 0);
  std::map<std::string, Asked> to_run;
  for (const std::string& target : targets)
    if (!is_result(target))
      to_run.emplace(target, read_asked_or_sweep(target));
  Checks checks;
  try {
    for (const std::string& target : targets) {
      const auto asked = to_run.find(target);
      if (asked == to_run.end() && is_sweep_folder(target)) {
        check_sweep_folder(target, checks);
      } else if (asked == to_run.end()) {
        results::require_readable(target);
        checks.add(summary_of(results::read_result(target)));
      } else {
        check_cases(asked->second, uses_cache, cache, checks);
      }
      if (is_interrupted())
        break;
      checks.end_target(target);
    }
  } catch (const std::exception& error) { // still report what was found
    checks.add_problem("check", error.what(), exit_internal);
    checks.end(junit);
    throw;
  }
  return checks.end(junit);
}

} // namespace asperity::app
