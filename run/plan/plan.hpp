#pragma once

// The plan of a run: jobs, steps, unknowns, predicted memory, what is cached
// and what is skipped. Making a plan computes no results and writes nothing.

#include "run/plan/run_options.hpp"
#include "run/plan/skipped.hpp"

#include <string>
#include <vector>

namespace asperity::run {

/// One method on all of its realisations.
struct PlannedMethod {
  std::string name;
  int realizations = 0;
  int steps = 0;      ///< total over all realisations
  int kept_steps = 0; ///< number of cached steps
  Grid grid; ///< without points for a theory that uses the spectrum formula
  double unknowns = 0.0; ///< per load step
  double memory = 0.0;   ///< per running realisation [B]
  bool runs_alone = false;
  int ranks = 1;              ///< that share the rows of the surface
  double rank_memory = 0.0;   ///< of each of several ranks [B]
  std::string why_alone = {}; ///< see obstacle_to_sharing()
};

struct Plan {
  std::vector<PlannedMethod> methods;
  std::vector<results::Skipped> skipped;
  std::vector<std::string> warnings; ///< about the results of the methods
  int threads = 1;
  double memory = 0.0; ///< predicted peak [B], within memory_factor
  double disk = 0.0;   ///< predicted size of result.h5 [B]
};

/// @throws input::InputError  an unknown method name, or a map, a mesh or a
///                            table of factors that cannot be read
Plan make_plan(const cases::Case& contact_case, const RunOptions& options);

/// Formats the plan as a readable table, followed by the skipped work and the
/// warnings.
std::string plan_text(const Plan& plan, const cases::Case& contact_case);

/// Names the methods of a plan whose rows the ranks of mpirun share, with the
/// memory of a rank, a line each; empty if there are none.
std::string shared_rows_text(const Plan& plan);

/// Returns the reason why a run does not fit into memory, such as "needs 128
/// GiB of memory, but 12 GiB are available", and possible remedies. The text is
/// empty if the run fits or if its memory cannot be predicted.
std::string refusal_of(const Plan& plan);

/// Checks that a run fits into the available memory. A measured map on its own
/// grid is not checked, because its file limits the size.
///
/// @throws input::InputError  the run does not fit
void require_memory(const cases::Case& contact_case, const RunOptions& options);

} // namespace asperity::run
