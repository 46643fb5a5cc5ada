// `asperity report`: the report of one or more results, compared side by side.
#include "input/input_error.hpp"
#include "reports/analysis/measured_curve.hpp"
#include "reports/pages/pdf_page.hpp"
#include "reports/pages/report.hpp"
#include "results/result_reader.hpp"
#include "results/trial_read.hpp"
#include "run/arguments/case_options.hpp"
#include "run/cli/run_command.hpp"
#include "run/cli/sweep_commands.hpp"
#include "run/output.hpp"
#include "run/output_folder.hpp"
#include "run/result_outputs.hpp"
#include "run/saved_studies.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace asperity::cli {

void require_pdf_program() {
  if (reports::pdf_program().empty())
    throw std::domain_error(reports::no_pdf_program);
}

reports::ReportExtras extras_of(const ReportForms& forms) {
  if (forms.has_pdf)
    require_pdf_program();
  reports::ReportExtras extras{
      .has_pdf = forms.has_pdf,
      .journal = reports::journal_format(forms.formats, forms.width)};
  extras.journal.units = forms.units;
  return extras;
}

run::ExitCode exit_of_figures(const std::vector<std::string>& undrawn,
                              bool are_asked_for) {
  return are_asked_for && !undrawn.empty() ? run::exit_internal
                                           : run::exit_good;
}

namespace {

namespace fs = std::filesystem;

struct ReportCommand {
  std::vector<std::string> paths; ///< results, or their folders
  std::string out; ///< empty: beside a single result, or out/comparison
  ReportForms forms;
  std::vector<std::string> labels; ///< names of the results, in order
  std::string fluid;               ///< of --flow; empty: none
  std::vector<std::string> asked;  ///< keys of studies
  std::vector<std::string> only;   ///< names of figures; empty: all
};

/// A table of a measured curve, rather than a result.
bool is_curve_file(const fs::path& path) {
  return fs::is_regular_file(path) && path.extension() != ".h5";
}

/// Reads results and the curves that are shown beside the first of them.
std::vector<results::Result>
results_or_curves(const std::vector<std::string>& paths) {
  if (is_curve_file(paths.front()))
    throw input::InputError(paths.front() +
                            ": is no result; the first argument must be a "
                            "result, with which a curve is compared");
  for (const std::string& path : paths)
    if (!is_curve_file(path))
      results::require_readable(path);
  std::vector<results::Result> read;
  read.reserve(paths.size());
  for (const std::string& path : paths)
    read.push_back(
        is_curve_file(path)
            ? reports::read_measured_curve(path, read.front())
            : results::read_result(path, results::MapsInFile::large));
  return read;
}

/// Adds the studies that the command asks for to the results.
void add_studies(const ReportCommand& command,
                 std::vector<results::Result>& read) {
  std::vector<std::string> asked = command.asked;
  if (!command.fluid.empty())
    for (const std::string& key : run::flow_overrides(command.fluid))
      asked.push_back(key);
  if (asked.empty())
    return;
  for (results::Result& result : read)
    if (!is_curve_file(result.path))
      fmt::print("{}: the studies are added to {} steps with saved maps\n",
                 result.path, run::ask_of_saved(result, asked));
}

/// Writes one report on the results at these paths.
///
/// @throws std::domain_error  a format or the width is unknown, or a PDF is
///         asked for and no program that prints one is installed
run::ExitCode report_results(const ReportCommand& command) {
  const std::vector<std::string>& paths = command.paths;
  const std::string& out = command.out;
  reports::ReportExtras extras = extras_of(command.forms);
  extras.labels = command.labels;
  extras.only = command.only;
  if (command.labels.size() > paths.size())
    throw input::InputError(fmt::format(
        "--label is given {} times for {} result{}", command.labels.size(),
        paths.size(), paths.size() == 1 ? "" : "s"));
  for (const std::string& path : paths)
    if (is_sweep_folder(path)) {
      if (paths.size() > 1)
        throw input::InputError(path +
                                " is a sweep, whose report is written by "
                                "itself; to compare points, give their "
                                "folders: " +
                                path + "/points/000");
      if (!command.fluid.empty() || !command.asked.empty())
        throw input::InputError(path +
                                " is a sweep; --flow and --set add a study to "
                                "a result, such as " +
                                path + "/points/000");
      return report_sweep(path, out, extras);
    }
  std::vector<results::Result> read = results_or_curves(paths);
  add_studies(command, read);
  const fs::path first = paths.front();
  const fs::path folder = !out.empty()              ? fs::path(out)
                          : paths.size() > 1        ? fs::path("out/comparison")
                          : fs::is_directory(first) ? first
                                                    : first.parent_path() / ".";
  const run::OutputFolder lock(folder, "report", run::report_outputs(),
                               {paths.begin(), paths.end()});
  const std::vector<std::string> failures =
      reports::write_report(read, folder, "gnuplot", extras);
  run::print_undrawn(failures);
  const run::ExitCode end =
      exit_of_figures(failures, !command.forms.formats.empty());
  fmt::print("report: {}\n", (folder / "report.html").string());
  run::JsonAnswer answer("asperity-report");
  for (const results::Result& result : read)
    if (is_curve_file(result.path)) {
      if (run::wants_json()) {
        const cases::Case none = reports::case_of(result);
        const reports::Summary summary =
            reports::entry_of(result, none).summary;
        answer.add(result.case_name, folder, end, &summary);
      }
    } else {
      add_answer(answer, result.case_name,
                 fs::is_directory(result.path)
                     ? fs::path(result.path)
                     : fs::path(result.path).parent_path(),
                 end);
    }
  answer.print(end);
  return end;
}

} // namespace

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
  command
      ->add_option("--flow", report.fluid,
                   "the leak of this fluid at the loads with saved maps:\n"
                   "water, air, or a viscosity such as \"0.1 Pa s\"")
      ->type_name("FLUID");
  command
      ->add_option("--set", report.asked,
                   "add a study at the loads with saved maps, as\n"
                   "--set spots.smallest=10")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command
      ->add_option("--only", report.only,
                   "draw only figures whose names begin so, as\n"
                   "pressure-gap,map")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--out", report.out,
                      "output folder (default: that of a single result,\n"
                      "else out/comparison)");
  add_report_forms(command, report.forms);
  add_quiet(command, line.output);
  add_json(command, line.output, "the summaries");
  add_example(command, "report out/polymer --figures pdf --width 86mm");
}

} // namespace asperity::cli
