#pragma once

// From an error that is asked to the cheapest setting predicted to keep it,
// and whether it did. Owns the choice; the runs are BenchRunner's.

#include <map>
#include <string>
#include <vector>

#include "bench/analysis/forecast.hpp"
#include "bench/runs/bench_runner.hpp"

namespace asperity::app {

/// Runs the coarse grids, fits error and cost, chooses, verifies, and chooses
/// again from what that found. Points are the case's; the element and the
/// layers' growth are chosen by method. Atoms and the theory have no such limit
/// and are left alone.
class TargetSearch {
public:
  TargetSearch(const cases::Case& contact_case, BenchRunnerOptions options);

  /// Chooses the cheapest setting whose every quantity is predicted to err by
  /// less than `target`, relative (the gap: in h_rms), up to four times the
  /// case's points. Its problem says why there is none, and which part of the
  /// error is to blame.
  reports::TargetOutcome choose(double target);

  /// Holds answers at the chosen setting against the exact solution, or
  /// against one run each with twice the points and half the growth. A promise
  /// that was broken is learnt from.
  /// @param chosen  by method
  void verify(reports::TargetOutcome& outcome,
              const std::map<std::string, reports::BenchAnswer>& chosen);

  /// Another setting, chosen with what the last verification found: true, and
  /// `outcome` is that of the new one. False after three settings, or where
  /// none is predicted to keep the error any more: `outcome` stays and its
  /// `earlier` says so.
  bool choose_again(reports::TargetOutcome& outcome);

  /// All of them, with the runs at the chosen settings between.
  reports::TargetOutcome run(double target);

private:
  struct Choice {
    int points = 0;
    double growth_share = 1.0;
    double cpu_time = 0.0;                    ///< of all methods [s]
    std::map<std::string, Forecast*> methods; ///< of forecasts_
  };

  void make_forecasts();
  Forecast forecast_of(const std::string& method, const std::string& element);
  reports::BenchPoint run_at(const std::string& method,
                             const std::string& element, int points,
                             double growth_share,
                             const std::vector<std::string>& more = {});
  bool choose_at(int points, double growth_share, double target,
                 Choice& choice);
  bool find_choice(double target);
  int finest_points() const;
  void promise(reports::TargetOutcome& outcome) const;
  std::string why_none(double target);
  std::string depth_words(const Forecast& forecast, const std::string& column);
  void verify_method(reports::TargetOutcome& outcome, Forecast& forecast,
                     const reports::BenchAnswer& answer);

  const cases::Case& case_;
  BenchRunner runner_;
  std::vector<std::string> quantities_;
  std::vector<int> grids_; ///< of the coarse runs
  std::vector<Forecast> forecasts_;
  Choice choice_;
  int n_tries_ = 0;
  double search_cpu_time_ = 0.0;
  std::string problem_;
};

} // namespace asperity::app
