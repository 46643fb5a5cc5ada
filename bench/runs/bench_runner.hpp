#pragma once

// One setting of a benchmark from its overrides to what it cost and answered:
// the program as a child process, some times over. Owns repeats and budget.

#include "cases/types/case.hpp"

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bench/analysis/bench.hpp"

namespace asperity::app {

struct BenchRunnerOptions {
  std::filesystem::path case_file;
  std::vector<std::string> common; ///< overrides of every run
  std::filesystem::path folder;    ///< for results and logs of the runs
  int repeats = 3;                 ///< timed, after one that warms up
  double budget = 300.0;           ///< wall time [s], see is_spent()
};

/// Runs settings one after another, each on one thread. A setting is run once
/// to warm up and then `repeats` times; of a setting of the truth, and once the
/// budget is spent, the first run counts and stays the only one.
class BenchRunner {
public:
  /// @param contact_case  whose expectations name quantities at a load;
  ///                      outlives the runner
  BenchRunner(const cases::Case& contact_case, BenchRunnerOptions options);

  /// Fills what the point cost and answered, or its problem.
  void run(reports::BenchPoint& point);

  /// True once the runs have taken the budget: the next ones are run once.
  bool is_spent() const;

private:
  struct Once;
  Once run_once(const reports::BenchPoint& point);
  double transform_pair(const Grid& grid);

  const cases::Case& case_;
  BenchRunnerOptions options_;
  std::chrono::steady_clock::time_point start_;
  std::map<std::pair<int, int>, double> transform_pairs_; ///< by grid [s]
  int n_runs_ = 0;
};

} // namespace asperity::app
