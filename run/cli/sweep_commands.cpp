#include "run/cli/sweep_commands.hpp"

#include "input/input_error.hpp"
#include "reports/analysis/verdict.hpp"
#include "reports/sweeps/sweep_report.hpp"
#include "run/interrupt.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/new_output.hpp"
#include "run/output_folder.hpp"
#include "run/sweeps/sweep_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace asperity::cli {
namespace {

namespace fs = std::filesystem;

/// Prints what is not as expected, and returns the exit code of all points.
run::ExitCode print_findings(const reports::SweepRecord& record,
                             const reports::SweepReport& report) {
  run::ExitCode end = run::exit_good;
  int judged = 0;
  int met = 0;
  for (const auto& result : report.results) {
    if (!result->has_result())
      continue;
    end = worse(end, exit_code_of(result->summary));
    for (const reports::Verdict& verdict : result->summary.verdicts) {
      if (verdict.outcome == reports::Outcome::skipped)
        continue;
      ++judged;
      met += verdict.is_passed() ? 1 : 0;
      if (!verdict.is_passed())
        fmt::print("point {:03}, {}: {}\n", result->point,
                   record.label(result->point), reports::check_line(verdict));
    }
  }
  if (judged > 0)
    fmt::print("{} of {} expectations are met\n", met, judged);
  return end;
}

/// The files that a sweep is read from.
std::vector<fs::path> inputs_of(const run::NamedSweep& named) {
  std::vector<fs::path> files;
  if (named.text.empty())
    files.emplace_back(named.sweep.path);
  for (const cases::SweptPoint& point : named.sweep.points)
    if (!point.contact_case.surface.file.empty())
      files.emplace_back(point.contact_case.surface.file);
  return files;
}

struct SweepEnd {
  run::SweepOutcome outcome;
  std::optional<reports::SweepReport> report;
  fs::path folder; ///< of the output
};

/// Runs a sweep and writes its report beside the output of an earlier run,
/// which both replace if all points are complete.
SweepEnd run_to(const run::NamedSweep& named, const RunCommand& command,
                const fs::path& folder) {
  run::NewOutput output(folder, command.resume, reports::sweep_file);
  fmt::print("{}: {}\n", named.sweep.name, named.sweep.title);
  SweepEnd ended{
      run::run_sweep(named.sweep, options_of(named, output.place(), command)),
      {},
      {}};
  if (!command.no_report)
    ended.report = reports::write_sweep_report(
        ended.outcome.record, output.place(), output.place(), true,
        {.has_pdf = command.has_pdf});
  if (ended.report)
    run::print_undrawn(ended.report->undrawn);
  if (std::ranges::all_of(
          ended.outcome.record.points,
          [](const reports::PointRecord& one) { return one.problem.empty(); }))
    output.replace();
  ended.folder = output.place();
  return ended;
}

/// Adds the findings at all points; a point without a result is a problem.
void add_checks(
    const reports::SweepRecord& record,
    const std::vector<std::unique_ptr<reports::SweptResult>>& results,
    const fs::path& folder, Checks& checks) {
  for (const auto& result : results) {
    const std::string name =
        fmt::format("{}, point {:03}, {}", record.case_name, result->point,
                    record.label(result->point));
    if (result->has_result()) {
      reports::Summary summary = result->summary;
      summary.case_name = name;
      checks.add(folder, std::move(summary));
    }
    if (!result->problem.empty()) {
      fmt::print("{}: {}\n", name, result->problem);
      checks.add_problem(name, result->problem,
                         run::is_interrupted() ? run::exit_interrupted
                                               : run::exit_expectation_failed);
    }
  }
}

} // namespace

run::SweepRunOptions options_of(const run::NamedSweep& named,
                                const fs::path& folder,
                                const RunCommand& command) {
  run::SweepRunOptions options{
      named.found.file, named.overrides, command.methods,   folder,
      command.resume,   command.threads, command.uses_cache};
  options.has_reports = run::is_of_maps(named) && !command.no_report;
  options.write_case = [&] { run::write_made_case(named); };
  return options;
}

bool is_sweep_folder(const fs::path& folder) {
  return fs::exists(folder / reports::sweep_file) &&
         !fs::exists(folder / "result.h5");
}

void print_sweep_plan(const run::NamedSweep& named, const RunCommand& command) {
  run::RunOptions options{{}, command.methods, command.resume, command.threads};
  methods::Cache cache(methods::cache_folder(),
                       command.uses_cache ? methods::cache_size() : 0);
  options.cache = &cache;
  fmt::print("{}",
             run::sweep_plan_text(run::make_sweep_plan(named.sweep, options),
                                  named.sweep));
}

run::ExitCode run_named_sweep(const run::NamedSweep& named,
                              const RunCommand& command,
                              const fs::path& folder) {
  if (!command.target_error.empty())
    throw input::InputError("--target-error: " + named.sweep.path +
                            " is a sweep, but a target error is met for one "
                            "case; --set sweep= removes the sweep");
  const run::OutputFolder lock(folder, "run " + named.sweep.name,
                               run::outputs_of(named), inputs_of(named));
  const SweepEnd ended = run_to(named, command, folder);
  run::ExitCode end = ended.outcome.worst;
  if (ended.report) {
    fmt::print("{}", ended.report->answer);
    end = worse(end, print_findings(ended.outcome.record, *ended.report));
    fmt::print("report: {}\n", (ended.folder / "report.html").string());
  }
  if (ended.outcome.is_interrupted) {
    fmt::print("interrupted; continue with --resume\n");
    return run::exit_interrupted;
  }
  return end;
}

run::ExitCode merge_sweep(const fs::path& folder, bool no_report,
                          bool has_pdf) {
  const reports::SweepRecord record = reports::read_sweep_record(folder);
  std::string lacking;
  int n_lacking = 0;
  run::ExitCode end = run::exit_good;
  for (const auto& result : reports::read_swept_results(record, folder, true)) {
    if (exit_code_of(result->summary) == run::exit_not_converged)
      end = run::exit_not_converged;
    if (result->problem.empty())
      continue;
    ++n_lacking;
    lacking += fmt::format("\n  point {:03} ({}): {}", result->point,
                           record.label(result->point), result->problem);
  }
  if (n_lacking > 0)
    throw input::InputError(fmt::format(
        "{}: {} of {} points {} missing or incomplete; run the parts that have "
        "them{}",
        folder.string(), n_lacking, record.points.size(),
        n_lacking == 1 ? "is" : "are", lacking));
  fs::remove(folder / "result.h5"); // of a case, which the sweep replaces
  if (no_report)
    return end;
  const reports::SweepReport report = reports::write_sweep_report(
      record, folder, folder, true, {.has_pdf = has_pdf});
  run::print_undrawn(report.undrawn);
  end = print_findings(record, report);
  fmt::print("report: {}\n", (folder / "report.html").string());
  return end;
}

run::ExitCode report_sweep(const fs::path& folder, const std::string& out,
                           const reports::ReportExtras& extras) {
  const reports::SweepRecord record = reports::read_sweep_record(folder);
  const fs::path target = out.empty() ? folder : fs::path(out);
  const run::OutputFolder lock(target, "report", run::report_outputs());
  const reports::SweepReport report =
      reports::write_sweep_report(record, folder, target, false, extras);
  run::print_undrawn(report.undrawn);
  fmt::print("report: {}\n", (target / "report.html").string());
  return exit_of_figures(report.undrawn, !extras.journal.endings.empty());
}

void check_sweep_folder(const fs::path& folder, Checks& checks) {
  const reports::SweepRecord record = reports::read_sweep_record(folder);
  add_checks(record, reports::read_swept_results(record, folder, false), folder,
             checks);
}

void add_sweep_answer(run::JsonAnswer& answer, const fs::path& folder,
                      run::ExitCode exit_code) {
  const reports::SweepRecord record = reports::read_sweep_record(folder);
  for (const auto& result : reports::read_swept_results(record, folder, false))
    answer.add(fmt::format("{}, point {:03}, {}", record.case_name,
                           result->point, record.label(result->point)),
               folder, exit_code,
               result->has_result() ? &result->summary : nullptr,
               result->problem);
}

void check_named_sweep(const run::NamedSweep& named, const RunCommand& command,
                       const fs::path& folder, Checks& checks) {
  const run::OutputFolder lock(folder, "check " + named.sweep.name,
                               run::sweep_outputs(), {named.sweep.path});
  const SweepEnd ended = run_to(named, command, folder);
  add_checks(ended.outcome.record, ended.report->results, folder, checks);
}

} // namespace asperity::cli
