#include "cli/case_run.hpp"

#include "cases/reader/case_hash.hpp"
#include "cli/checks.hpp"
#include "methods/cache/cache.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "run/last_run.hpp"
#include "run/plan/finished_output.hpp"
#include "run/result_outputs.hpp"
#include "run/run_case.hpp"

#include <fmt/format.h>

#include <optional>
#include <vector>

namespace asperity::cli {
namespace {

struct EndedRun {
  run::ExitCode exit_code = run::exit_good;
  bool is_complete = false; ///< every step converged, every figure is drawn
};

/// @param figures  receives the figures; null: they are not needed
EndedRun run_and_report(const cases::Case& contact_case,
                        const run::RunOptions& options,
                        const ReportChoice& report,
                        std::vector<reports::DrawnGroup>* figures) {
  fmt::print("{}: {}\n", contact_case.name, contact_case.title);
  const run::RunOutcome outcome = run::run_case(contact_case, options);
  EndedRun ended{run::exit_good,
                 !outcome.is_interrupted && outcome.failed_steps == 0};
  if (!report.is_omitted) {
    const run::WrittenOutputs written =
        run::write_outputs(options.folder, report.has_pdf, figures);
    ended.exit_code = print_findings(written.summary, options.folder);
    ended.is_complete = ended.is_complete && written.has_all_figures;
  } else if (outcome.failed_steps > 0)
    ended.exit_code = run::exit_not_converged;
  if (outcome.is_interrupted) {
    if (!report.is_omitted)
      fmt::print("interrupted; continue with --resume\n");
    ended.exit_code = run::exit_interrupted;
  }
  return ended;
}

int n_steps_of(const results::Result& result) {
  std::size_t steps = 0;
  for (const results::MethodRecord& method : result.methods)
    for (const results::Curve& curve : method.realizations)
      steps += curve.points.size();
  return static_cast<int>(steps);
}

void write_kept(const cases::Case& contact_case, const run::RunOptions& options,
                const run::OutputFiles& files) {
  fmt::print("{}: {}\n", contact_case.name, contact_case.title);
  run::put_last_run_aside(options.folder);
  run::write_output(options.folder, files);
}

/// Takes over the output of a run, whose numbers are those of this case, and
/// writes the pages again.
run::ExitCode report_again(const cases::Case& contact_case,
                           const run::RunOptions& options,
                           const ReportChoice& report,
                           const run::OutputKeys& keys,
                           const run::KeptNumbers& kept) {
  write_kept(contact_case, options, kept.files);
  results::replace_case(options.folder,
                        {contact_case.name, contact_case.title,
                         contact_case.text, cases::case_hash(contact_case),
                         contact_case.material.contact_modulus,
                         options.reference});
  std::vector<reports::DrawnGroup> figures =
      reports::drawn_groups_in(kept.figures);
  const run::WrittenOutputs written =
      run::write_outputs(options.folder, report.has_pdf, &figures);
  fmt::print("{0} steps: 0 computed, {0} from the cache, with the figures\n",
             n_steps_of(results::read_result(options.folder,
                                             results::MapsInFile::large)));
  const run::ExitCode ended = print_findings(written.summary, options.folder);
  if (written.has_all_figures)
    run::record_output(options.folder, keys, kept.figures, *options.cache);
  return ended;
}

} // namespace

run::ExitCode run_one(const cases::Case& contact_case,
                      const run::RunOptions& options,
                      const ReportChoice& report) {
  return run_and_report(contact_case, options, report, nullptr).exit_code;
}

run::ExitCode run_if_needed(const cases::Case& contact_case,
                            const run::RunOptions& options,
                            const ReportChoice& report) {
  if (!options.cache->is_on() || report.is_omitted)
    return run_one(contact_case, options, report);
  const run::OutputKeys keys = run::output_keys(
      contact_case, options, report.has_pdf ? "with report.pdf" : "");
  if (run::has_output(options.folder, keys.output)) {
    fmt::print("{}: {}\n{} is up to date; --no-cache computes it again\n",
               contact_case.name, contact_case.title, options.folder.string());
    return print_findings(run::summary_of(results::read_result(
                              options.folder, results::MapsInFile::large)),
                          options.folder);
  }
  if (!options.resume) {
    if (const auto files = run::cached_output(keys.output, *options.cache)) {
      write_kept(contact_case, options, *files);
      const results::Result result =
          results::read_result(options.folder, results::MapsInFile::large);
      fmt::print("{0} steps: 0 computed, {0} from the cache, with the report\n",
                 n_steps_of(result));
      return print_findings(run::summary_of(result), options.folder);
    }
    if (const auto kept = run::cached_numbers(keys.numbers, *options.cache))
      return report_again(contact_case, options, report, keys, *kept);
  }
  std::vector<reports::DrawnGroup> figures;
  const EndedRun ended =
      run_and_report(contact_case, options, report, &figures);
  if (ended.is_complete)
    run::record_output(options.folder, keys, reports::bytes_of(figures),
                       *options.cache);
  return ended.exit_code;
}

} // namespace asperity::cli
