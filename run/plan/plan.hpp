#pragma once

// The plan of a run: jobs, predicted time and memory, and what is cached.
// Making a plan computes no results and writes nothing.

#include "run/plan/machine_rates.hpp"
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
  double unknowns = 0.0;   ///< per load step
  double setup_time = 0.0; ///< CPU [s]; 0 if everything is cached
  double step_time = 0.0;  ///< CPU, total of all steps that are not cached [s]
  double memory = 0.0;     ///< per running realisation [B]
  bool runs_alone = false;
  int ranks = 1;              ///< that share the rows of the surface
  double rank_memory = 0.0;   ///< of each of several ranks [B]
  std::string why_alone = {}; ///< see obstacle_to_sharing()
};

/// The plan of a run. Times and sizes are predictions; NaN where no prediction
/// exists.
struct Plan {
  std::vector<PlannedMethod> methods;
  std::vector<results::Skipped> skipped;
  std::vector<std::string> warnings; ///< about the results of the methods
  int threads = 1;
  double base_time = 0.0;  ///< start-up, surfaces and result file, CPU [s]
  double study_time = 0.0; ///< tables of the studies, CPU [s]
  double cpu_time = 0.0;   ///< total without the report [s]
  double wall_time = 0.0;  ///< total without the report [s]
  double memory = 0.0;     ///< peak [B]
  double disk = 0.0;       ///< size of result.h5 [B]
  double factor = 2.0;     ///< uncertainty of CPU time and memory [1]
};

/// Makes the plan of a run.
///
/// @param largest_probe  see MachineRates
/// @throws input::InputError  an unknown method name, or a map, a mesh or a
///                            table of factors that cannot be read
Plan make_plan(const cases::Case& contact_case, const RunOptions& options,
               int largest_probe = 1024);

/// Does the same with rates that several plans share.
Plan make_plan(const cases::Case& contact_case, const RunOptions& options,
               MachineRates& rates);

/// Formats a time as "12 s", "3 min" or "1.5 h", and a size as "12 MB" or "1.5
/// GB"; "?" if it is unknown (NaN).
std::string time_text(double seconds);
std::string size_text(double bytes);

/// Computes cpu_time and wall_time from the times of the parts and the number
/// of threads. Methods share the threads, except that those marked runs_alone
/// run one after another.
void add_up_times(Plan& plan);

/// Formats the plan as a readable table, followed by the skipped work and the
/// warnings.
std::string plan_text(const Plan& plan, const cases::Case& contact_case);

/// Names the methods of a plan whose rows the ranks of mpirun share, with the
/// memory of a rank, a line each; empty if there are none.
std::string shared_rows_text(const Plan& plan);

} // namespace asperity::run
