#pragma once

// What a run would do: jobs, predicted time and memory, what the cache has.
// Computes no answer and writes nothing.

#include "app/plan/run_options.hpp"
#include "app/plan/skipped.hpp"

#include <string>
#include <vector>

namespace asperity::app {

/// One method, all its realisations.
struct PlannedMethod {
  std::string name;
  int realizations = 0;
  int steps = 0;           ///< on all realisations
  int kept_steps = 0;      ///< of them in the cache
  Grid grid;               ///< of no points for a theory by the formula
  double unknowns = 0.0;   ///< of one step
  double setup_time = 0.0; ///< CPU [s]; 0 if all is kept
  double step_time = 0.0;  ///< CPU of the steps that are not kept [s]
  double memory = 0.0;     ///< of one realisation at work [B]
  bool runs_alone = false;
};

/// Times and sizes are predictions; NaN where nothing is known.
struct Plan {
  std::vector<PlannedMethod> methods;
  std::vector<results::Skipped> skipped;
  std::vector<std::string> warnings; ///< about the methods' answers
  int threads = 1;
  double base_time = 0.0;  ///< of the program itself, CPU [s]
  double study_time = 0.0; ///< of tables, CPU [s]
  double cpu_time = 0.0;   ///< of the run, without the report [s]
  double wall_time = 0.0;  ///< [s]
  double memory = 0.0;     ///< peak [B]
  double disk = 0.0;       ///< of result.h5 [B]
  double factor = 2.0;     ///< that CPU time and memory may be off by [1]
};

/// @param largest_probe  see MachineRates
/// @throws cases::CaseError  an unknown method name; a map or a table of
///                           factors that cannot be read
Plan make_plan(const cases::Case& rough_case, const RunOptions& options,
               int largest_probe = 1024);

/// Fills in cpu_time and wall_time from the times of the parts and the number
/// of threads: methods share the threads, those that run alone one by one.
void add_up_times(Plan& plan);

/// As a table for people, with what is skipped and the warnings below.
std::string plan_text(const Plan& plan, const cases::Case& rough_case);

} // namespace asperity::app
