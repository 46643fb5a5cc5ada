#pragma once

// What a case asks of the theory besides its curve, run and recorded.

#include "app/run/method_job.hpp"

namespace asperity::app {

/// Runs [magnification] and [adhesion] of a case and records their tables
/// (docs/results.md); one that is in the file already is not run again. An
/// interrupt ends it between two tables. Tables that the cache has are read.
/// @param theory  study_theory() of the case
void run_studies(const RunScene& scene, const cases::MethodSpec& theory);

} // namespace asperity::app
