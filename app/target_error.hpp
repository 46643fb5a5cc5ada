#pragma once

// From an error that is asked to the cheapest setting predicted to keep it,
// and whether it did. Owns the prediction; the runs are BenchRunner's.

#include "app/bench_runner.hpp"
#include "app/forecast.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::app {

/// Runs the coarse grids, fits error and cost, chooses, and verifies. Points
/// are the case's; the element and the layers' growth are chosen by method.
/// Atoms and the theory have no such limit and are left alone.
class TargetSearch {
public:
  TargetSearch(const cases::Case& contact_case, BenchRunnerOptions options);

  /// Chooses the cheapest setting whose every quantity is predicted to err by
  /// less than `target`, relative (the gap: in h_rms), up to four times the
  /// case's points. Its problem says why there is none.
  reports::TargetOutcome choose(double target);

  /// Holds answers at the chosen setting against one run each with twice the
  /// points and half the growth, or against the exact solution.
  /// @param chosen  by method
  void verify(reports::TargetOutcome& outcome,
              const std::map<std::string, reports::BenchAnswer>& chosen);

  /// Both, with the runs at the chosen setting between them.
  reports::TargetOutcome run(double target);

private:
  struct Choice {
    int points = 0;
    double growth_share = 1.0;
    double cpu_time = 0.0; ///< of all methods [s]
    std::map<std::string, const Forecast*> methods;
  };

  void make_forecasts();
  Forecast forecast_of(const std::string& method, const std::string& element);
  reports::BenchPoint run_at(const std::string& method,
                             const std::string& element, int points,
                             double growth_share);
  bool choose_at(int points, double growth_share, double target,
                 Choice& choice) const;
  double largest_error(const Forecast& forecast, int points,
                       double growth_share) const;

  const cases::Case& case_;
  BenchRunner runner_;
  std::vector<std::string> quantities_;
  std::vector<int> grids_; ///< of the coarse runs
  std::vector<Forecast> forecasts_;
  Choice choice_;
  double search_cpu_time_ = 0.0;
  std::string problem_;
};

/// A line a quantity: "promised 1 %, found 0.7 %".
void print_outcome(const reports::TargetOutcome& outcome);

} // namespace asperity::app
