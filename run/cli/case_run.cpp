#include "run/cli/case_run.hpp"

#include "input/input_error.hpp"
#include "run/cli/checks.hpp"
#include "run/new_output.hpp"
#include "run/result_outputs.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace asperity::cli {

CaseEnd run_into_folder(const cases::Case& contact_case,
                        const run::RunOptions& options,
                        const ReportChoice& report) {
  run::NewOutput output(options.folder, options.resume);
  run::RunOptions beside = options;
  beside.folder = output.place();
  CaseEnd ended{{}, output.place(), {}};
  try {
    ended.outcome = run::run_case(contact_case, beside);
  } catch (const input::InputError&) { // after the result was closed
    output.drop();
    throw;
  } catch (const std::domain_error&) {
    output.drop();
    throw;
  }
  if (!report.is_omitted)
    ended.summary = run::write_outputs(output.place(), report.has_pdf, true);
  if (!ended.outcome.is_interrupted)
    output.replace();
  ended.folder = output.place();
  return ended;
}

run::ExitCode run_one(const cases::Case& contact_case,
                      const run::RunOptions& options,
                      const ReportChoice& report) {
  fmt::print("{}: {}\n", contact_case.name, contact_case.title);
  const CaseEnd ended = run_into_folder(contact_case, options, report);
  run::ExitCode end = run::exit_good;
  if (ended.summary)
    end = print_findings(*ended.summary, ended.folder);
  else if (ended.outcome.failed_steps > 0)
    end = run::exit_not_converged;
  if (!ended.outcome.is_interrupted)
    return end;
  if (!report.is_omitted)
    fmt::print("interrupted; continue with --resume\n");
  return run::exit_interrupted;
}

} // namespace asperity::cli
