#pragma once

// Runs one case from its case file to its result file. This file defines the
// list of jobs, their order and their threads.

#include "input/types/case.hpp"
#include "results/result_writer.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/plan/run_options.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::run {

struct RunOutcome {
  bool is_interrupted = false;
  int failed_steps = 0; ///< not converged
  int computed_steps = 0;
  int kept_steps = 0; ///< read from the cache
};

/// Runs the methods of a case and writes each step to folder/result.h5 as soon
/// as it is done, which replaces an older one unless the run resumes it. Jobs
/// (a method on a realisation) run in parallel; a method whose library allows
/// only one run at a time runs after the others. The numbers do not depend on
/// the distribution of the jobs. If the options name realisations, the result
/// holds only these; the tables of the studies and of the subsurface stress
/// belong to realisation 0. Cached steps are read, including their CPU times,
/// instead of being computed, and the result records this.
///
/// Under mpirun all ranks run the case if they share one of its methods, and
/// only rank 0 reads and writes results and the cache.
///
/// @throws input::InputError  an unknown method name, or a module rejects the
///                            case
RunOutcome run_case(const cases::Case& contact_case, const RunOptions& options);

/// Does what run_case() does before it needs memory or a folder.
/// @return  the grid of the surface, without points if it has none
/// @throws input::InputError  as run_case()
Grid require_runnable(const cases::Case& contact_case,
                      const std::vector<cases::MethodSpec>& methods);

/// To be called on the other ranks of mpirun. Takes part in a run_case() of
/// rank 0: reads the case from the text that rank 0 has sent and does the same
/// steps, but writes nothing.
void follow_run(const std::string& text);

} // namespace asperity::run
