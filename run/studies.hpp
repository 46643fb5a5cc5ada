#pragma once

// Runs the theoretical studies of a case and records their tables.

#include "run/method_job.hpp"

namespace asperity::run {

/// Runs [magnification] and [adhesion] of a case and records their tables
/// (docs/reference/results.md). Tables that are already in the file are not
/// computed again, and cached tables are read. An interrupt takes effect
/// between two tables.
///
/// @param theory  study_theory() of the case
void run_studies(const RunContext& context, const cases::MethodSpec& theory);

} // namespace asperity::run
