#pragma once

// One case of `asperity run`: it is computed, or taken from its folder or from
// the cache, as far as these hold what the run would write.

#include "cases/types/case.hpp"
#include "run/exit_code.hpp"
#include "run/plan/run_options.hpp"

namespace asperity::cli {

struct ReportChoice {
  bool is_omitted = false;
  bool has_pdf = false;
};

/// Runs a case and writes its report. Nothing is read from earlier reports.
run::ExitCode run_one(const cases::Case& contact_case,
                      const run::RunOptions& options,
                      const ReportChoice& report);

/// Runs a case unless its folder or the cache already holds what the run would
/// write. If only the numbers and figures are there, as after a change of the
/// title or of [expect], the pages are written again. Without the cache or a
/// report the case is run in any case.
/// @param options  with a cache, perhaps one that is off
run::ExitCode run_if_needed(const cases::Case& contact_case,
                            const run::RunOptions& options,
                            const ReportChoice& report);

} // namespace asperity::cli
