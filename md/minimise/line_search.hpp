#pragma once

// The state of a minimisation together with a line search for a lower energy.
// It is shared by all minimisers with line searches.

#include "md/minimise/relaxation.hpp"
#include "md/minimise/system.hpp"

#include <string>
#include <vector>

namespace asperity::md {

class LineSearch {
public:
  /// Evaluates energy and forces at `state`, which later steps overwrite.
  /// @param state     stored by reference
  /// @param settings  stored by reference
  LineSearch(const System& system, std::vector<double>& state,
             const RelaxationSettings& settings);

  const std::vector<double>& forces() const { return forces_; }

  double residual() const { return residual_of(evaluation_, forces_); }

  int evaluations() const { return evaluations_; }

  bool is_budget_exhausted() const {
    return evaluations_ >= settings_.max_evaluations;
  }

  /// Returns the number of evaluations, the energy and the residuals of the
  /// present state.
  Relaxation report() const;

  /// Backtracks along a direction until a trial step lowers the energy without
  /// overshooting, and accepts that step.
  /// @param direction  full first trial step; it is shortened if
  ///                   RelaxationSettings::largest_step requires it
  /// @return  accepted step length relative to `direction`; 0 if the direction
  ///          points uphill or no trial step was acceptable
  double search(const std::vector<double>& direction, int most_trials);

  /// Returns the forces before the last accepted step.
  const std::vector<double>& previous_forces() const { return trial_forces_; }

  /// Returns a vector of the size of the state that callers may use between
  /// searches.
  std::vector<double>& scratch() { return trial_; }

private:
  Evaluation evaluate(const std::vector<double>& state,
                      std::vector<double>& forces);
  bool is_lower(const Evaluation& after, double slope_before,
                double slope_after) const;

  const System& system_;
  const RelaxationSettings& settings_;
  std::vector<double>& state_;
  std::vector<double> forces_;
  std::vector<double> trial_;
  std::vector<double> trial_forces_;
  Evaluation evaluation_;
  int evaluations_ = 0;
};

/// Returns why a minimisation must stop before convergence; empty if it may
/// continue.
std::string stop_reason(const Relaxation& now,
                        const RelaxationSettings& settings, const Watch& watch);

/// Checks the arguments of a minimiser.
/// @throws std::domain_error  a tolerance or step is not positive, or the state
///                            has a wrong size
void require_minimisable(const System& system, std::span<const double> state,
                         const RelaxationSettings& settings);

} // namespace asperity::md
