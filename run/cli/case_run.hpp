#pragma once

// One case of `run` and `check`: it is computed beside the output of an earlier
// run, which it replaces when it is complete.

#include "input/types/case.hpp"
#include "reports/analysis/summary.hpp"
#include "run/exit_code.hpp"
#include "run/plan/run_options.hpp"
#include "run/run_case.hpp"

#include <optional>

namespace asperity::cli {

struct ReportChoice {
  bool is_omitted = false;
  bool has_pdf = false;
};

struct CaseEnd {
  run::RunOutcome outcome;
  std::filesystem::path folder;            ///< of the output
  std::optional<reports::Summary> summary; ///< empty without a report
};

/// Runs a case into options.folder (run/new_output.hpp) and writes its report.
CaseEnd run_into_folder(const cases::Case& contact_case,
                        const run::RunOptions& options,
                        const ReportChoice& report);

/// The same, and prints what the report has found.
run::ExitCode run_one(const cases::Case& contact_case,
                      const run::RunOptions& options,
                      const ReportChoice& report);

} // namespace asperity::cli
