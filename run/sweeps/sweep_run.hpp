#pragma once

// Runs the points of a sweep beside each other, each as a child process that
// runs an ordinary case into its own folder, and resumes an interrupted sweep.

#include "input/sweeps/sweep.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "run/exit_code.hpp"
#include "run/plan/plan.hpp"
#include "run/plan/run_options.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace asperity::run {

struct SweepRunOptions {
  std::filesystem::path case_file;
  std::vector<std::string> overrides; ///< with which the sweep was read
  methods::AskedMethods methods;
  std::filesystem::path folder; ///< of sweep.json; the caller locks it
  bool resume = false;
  int threads = 0; ///< 0: all hardware threads
  bool uses_cache = true;
  bool has_reports = false;                 ///< of each point
  std::vector<std::size_t> points = {};     ///< indices, of a part, whose
                                            ///< points are all of one text;
                                            ///< empty: all points
  std::function<void()> write_case = [] {}; ///< if case_file is not there yet
};

struct SweepOutcome {
  reports::SweepRecord record; ///< with the problems of the points
  bool is_interrupted = false;
  ExitCode worst = exit_good; ///< of all points
};

/// Returns the plan of a sweep as its points and their cases state it.
reports::SweepRecord record_of(const cases::CaseSweep& sweep);

/// Writes folder/sweep.json.
void write_record(const reports::SweepRecord& record,
                  const std::filesystem::path& folder);

/// Runs all points of a sweep. Their results are in folder/points/NNN/, the
/// output of each run in log.txt there, and the plan in folder/sweep.json.
/// Where the sweep is resumed, a point whose result is complete, and of the
/// same case, inputs and program, is not run again; an incomplete one is
/// resumed.
///
/// Each point is a process of its own, so that one that fails or is killed does
/// not affect the others; when this process ends, they end too. Points run
/// beside each other as threads and predicted memory allow. The numbers do not
/// depend on that.
///
/// @throws input::InputError  a method that the case does not have, or a point
///                            that does not fit into memory; nothing is written
SweepOutcome run_sweep(const cases::CaseSweep& sweep,
                       const SweepRunOptions& options);

struct SweepPlan {
  std::vector<Plan> points;
  int threads = 1;             ///< of the whole sweep
  double available_memory = 0; ///< [B]

  /// Returns how many points run beside each other: as many as there are
  /// threads, and as fit into the memory. At least one.
  int beside() const;
};

/// Makes the plans of all points.
///
/// @param options  those of the sweep; the folder is not used
/// @throws input::InputError  as make_plan(); or a point that does not fit into
///                            the available memory, which is named
SweepPlan make_sweep_plan(const cases::CaseSweep& sweep,
                          const RunOptions& options);

/// Formats the points with their steps and predicted memory.
std::string sweep_plan_text(const SweepPlan& plan,
                            const cases::CaseSweep& sweep);

} // namespace asperity::run
