#pragma once

// What a case asks of the theory besides its curve, run and recorded.

#include "cases/case.hpp"
#include "results/result_writer.hpp"

namespace asperity::app {

/// Runs [magnification] and [adhesion] of a case and records their tables
/// (docs/results.md); one that is in the file already is not run again. An
/// interrupt ends it between two tables.
/// @param theory  study_theory() of the case
void run_studies(const cases::Case& rough_case, const cases::MethodSpec& theory,
                 results::ResultWriter& writer);

} // namespace asperity::app
