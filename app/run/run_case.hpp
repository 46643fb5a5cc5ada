#pragma once

// One case from its file to its result file: what is to be done, on how many
// threads, in which order. Owns the job list.

#include "app/cache/cache.hpp"
#include "app/plan/run_options.hpp"
#include "cases/types/case.hpp"
#include "results/result_writer.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::app {

struct RunOutcome {
  bool is_interrupted = false;
  int failed_steps = 0; ///< not converged
  int computed_steps = 0;
  int kept_steps = 0; ///< read from the cache
};

/// Runs the methods of a case and writes each step to folder/result.h5 as it
/// is done. An older result there is kept as result.previous.h5, unless the run
/// resumes it. Jobs (a method on a realisation) run beside each other; a method
/// whose library allows one at a time runs after the others. Which job runs
/// where changes nothing in the numbers. What the cache has is read, CPU times
/// among it, and not computed; the result says so.
/// @throws cases::CaseError  an unknown method name; what a room refuses
RunOutcome run_case(const cases::Case& rough_case, const RunOptions& options);

} // namespace asperity::app
