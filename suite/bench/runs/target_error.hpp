#pragma once

// Finds the cheapest setting that is predicted to meet an error target, and
// verifies whether it does. It owns the choice; the runs are those of
// BenchRunner.

#include "suite/bench/analysis/forecast.hpp"
#include "suite/bench/runs/bench_runner.hpp"

#include <map>
#include <string>
#include <vector>

namespace asperity::bench {

/// Runs the coarse grids, fits error and cost, chooses a setting, verifies it,
/// and chooses again with the information found. The number of points is common
/// to the case; the element and the grading ratio of the layers are chosen per
/// method. Atoms and the theory have no such limit and are not changed.
class TargetSearch {
public:
  TargetSearch(const cases::Case& contact_case, BenchRunnerOptions options);

  /// Chooses the cheapest setting for which every quantity is predicted to have
  /// a relative error below `target` (for the gap: in units of h_rms), with up
  /// to four times the points of the case. If there is none, its problem states
  /// why and which contribution to the error is responsible.
  TargetOutcome choose(double target);

  /// Compares the results at the chosen setting with the exact solution, or
  /// with one run per method at twice the points and half the logarithm of the
  /// grading ratio. A missed target updates the predictions.
  /// @param chosen  results by method
  void verify(TargetOutcome& outcome,
              const std::map<std::string, BenchAnswer>& chosen);

  /// Chooses another setting with the information from the last verification.
  /// True: `outcome` is that of the new setting. False after three settings, or
  /// if none is predicted to meet the target any more: `outcome` is unchanged
  /// except that its `earlier` states the reason.
  bool choose_again(TargetOutcome& outcome);

  /// Performs all of these steps, with the runs at the chosen settings in
  /// between.
  TargetOutcome run(double target);

private:
  struct Choice {
    int points = 0;
    double growth_share = 1.0;
    double cpu_time = 0.0;                    ///< sum over all methods [s]
    std::map<std::string, Forecast*> methods; ///< pointers into forecasts_
  };

  void make_forecasts();
  Forecast forecast_of(const std::string& method, const std::string& element);
  BenchPoint run_at(const std::string& method, const std::string& element,
                    int points, double growth_share,
                    const std::vector<std::string>& more = {});
  bool choose_at(int points, double growth_share, double target,
                 Choice& choice);
  bool find_choice(double target);
  bool permits(int points) const;
  int finest_points() const;
  void add_checks(TargetOutcome& outcome) const;
  std::string why_none(double target);
  std::string depth_words(const Forecast& forecast, const std::string& column);
  void verify_method(TargetOutcome& outcome, Forecast& forecast,
                     const BenchAnswer& answer);

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

/// Prints one line per quantity: "target 1 %, predicted 0.4 %, found 0.7 %:
/// met".
void print_outcome(const TargetOutcome& outcome);

/// Returns the same for the provenance of a result, including the earlier
/// attempts.
results::Provenance facts_of(const TargetOutcome& outcome);

} // namespace asperity::bench
