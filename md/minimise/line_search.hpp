#pragma once

// The state of a minimisation and the search for a lower energy along a given
// direction. Owns which trial step is taken, for every minimiser that searches.

#include "md/minimise/relaxation.hpp"
#include "md/minimise/system.hpp"

#include <string>
#include <vector>

namespace asperity::md {

class LineSearch {
public:
  /// Evaluates energy and forces at `state`, which later steps overwrite.
  /// @param state     kept by reference
  /// @param settings  kept by reference
  LineSearch(const System& system, std::vector<double>& state,
             const RelaxationSettings& settings);

  const std::vector<double>& forces() const { return forces_; }

  double residual() const { return residual_of(evaluation_, forces_); }

  int evaluations() const { return evaluations_; }

  bool is_used_up() const { return evaluations_ >= settings_.max_evaluations; }

  /// Evaluations, energy and residuals of the present state.
  Relaxation report() const;

  /// Tries shorter and shorter steps along a direction until one lowers the
  /// energy and does not overshoot, and takes it.
  /// @param direction  of the first trial step, which is as long as
  ///                   RelaxationSettings::largest_step allows
  /// @return  the length that was taken, in directions; 0 if the direction
  ///          points uphill or no trial step was good
  double search(const std::vector<double>& direction, int most_trials);

  /// The forces before the step that was taken last.
  const std::vector<double>& previous_forces() const { return trial_forces_; }

  /// A vector of the size of the state that callers may use between searches.
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

/// Why a minimisation must stop before it converged; empty to go on.
std::string stop_reason(const Relaxation& now,
                        const RelaxationSettings& settings, const Watch& watch);

/// @throws std::domain_error  a tolerance or step that is not positive, or a
///                            state that is not of the system's size
void require_minimisable(const System& system, std::span<const double> state,
                         const RelaxationSettings& settings);

} // namespace asperity::md
