#pragma once

// Runs one setting of a benchmark, from its overrides to its cost and results,
// by starting the program several times as a child process. It owns the repeats
// and the time budget.

#include "input/types/case.hpp"
#include "suite/bench/analysis/bench.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity::bench {

struct BenchRunnerOptions {
  std::filesystem::path case_file;
  std::vector<std::string> common; ///< overrides of every run
  std::filesystem::path folder;    ///< for the results and logs of the runs
  int repeats = 3;                 ///< timed runs, after one warm-up run
  double budget = 300.0;           ///< wall time [s], see is_spent()
};

/// Runs settings one after another, each on one thread. A setting is
/// run once as a warm-up and then `repeats` times. A setting of the reference
/// series is run only once, as are all settings after the budget is spent; this
/// single run is then timed.
class BenchRunner {
public:
  /// @param contact_case  its expectations name the quantities at a load; it
  ///     must outlive the runner
  BenchRunner(const cases::Case& contact_case, BenchRunnerOptions options);

  /// Fills the cost and the results of the point, or its problem.
  void run(BenchPoint& point);

  /// True once the runs have used up the budget; from then on each setting is
  /// run once.
  bool is_spent() const;

private:
  struct Once;
  Once run_once(const BenchPoint& point);
  double transform_pair(const Grid& grid);

  const cases::Case& case_;
  BenchRunnerOptions options_;
  std::chrono::steady_clock::time_point start_;
  std::map<std::pair<int, int>, double> transform_pairs_; ///< per grid [s]
  int n_runs_ = 0;
};

} // namespace asperity::bench
