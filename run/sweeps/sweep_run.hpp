#pragma once

// Runs the points of a sweep beside each other, each as a child process that
// runs an ordinary case into its own folder, and resumes an interrupted sweep.

#include "cases/sweeps/sweep.hpp"
#include "reports/sweeps/sweep_record.hpp"
#include "run/exit_code.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace asperity::run {

struct SweepRunOptions {
  std::filesystem::path case_file;
  std::vector<std::string> overrides; ///< with which the sweep was read
  std::vector<std::string> methods;   ///< names or kinds; empty: all
  bool is_exact = false;              ///< `methods` lists names only
  std::filesystem::path folder;       ///< of sweep.json; the caller locks it
  bool resume = false;
  int threads = 0; ///< 0: all hardware threads
  bool uses_cache = true;
  bool has_reports = false; ///< of each point
  bool is_part = false;     ///< runs only `points`, resumes them, and leaves
                            ///< sweep.json and the report as they are
  std::vector<std::size_t> points = {};     ///< indices, of a part
  std::function<void()> write_case = [] {}; ///< if case_file is not there yet
};

struct SweepOutcome {
  reports::SweepRecord record; ///< with the problems of the points
  bool is_interrupted = false;
  ExitCode worst = exit_good; ///< of all points
};

/// Returns the plan of a sweep as its points and their cases state it.
reports::SweepRecord record_of(const cases::CaseSweep& sweep);

/// Keeps the points of an earlier sweep as points.previous, and removes its
/// sweep.json and sweep.csv.
void put_points_aside(const std::filesystem::path& folder);

/// Writes folder/sweep.json, and removes the report of an earlier sweep or case
/// in this folder.
void write_record(const reports::SweepRecord& record,
                  const std::filesystem::path& folder);

/// Runs all points of a sweep. Their results are in folder/points/NNN/, the
/// output of each run in log.txt there, and the plan in folder/sweep.json. The
/// points of an earlier sweep are kept as points.previous, unless the sweep
/// resumes them: a point whose result is complete, and of the same case, inputs
/// and program, is not run again; an incomplete one is resumed.
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

} // namespace asperity::run
