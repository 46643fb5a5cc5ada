#pragma once

// Predicts how long a run still takes: from the predicted cost of its steps,
// scaled by the time that the finished ones took, once these are two per
// cent of the work.

#include <map>
#include <optional>
#include <string>

namespace asperity::run {

/// The steps of one method that are to be done, and their predicted cost.
struct MethodWork {
  int steps = 0;
  double step_time = 0.0; ///< predicted CPU time per step with its share of the
                          ///< set-up [s]; NaN: not predicted
};

/// The unfinished step of a run that takes longest.
struct StepAtWork {
  std::string method = {};
  double elapsed = 0.0; ///< wall time since it began [s]
  double share = 0.0;   ///< part that is done, 0 to 1; 0: not known
};

/// Returns the part of an iteration that is done, 0 to 1: the orders of
/// magnitude by which its residual, which was about 1, has fallen, over those
/// of the tolerance. It is 0 if the residual is not known.
double share_done(double residual, double tolerance);

/// The work of a run by method.
class RemainingWork {
public:
  /// @param wall_per_cpu  predicted wall time over CPU time [1] > 0
  RemainingWork(const std::map<std::string, MethodWork>& methods,
                double wall_per_cpu);

  /// Counts steps that were computed.
  void add_done(const std::string& method, int n_steps);

  /// Counts steps that need not be computed.
  void add_kept(const std::string& method, int n_steps);

  int steps() const { return n_steps_; }

  int steps_done() const { return n_done_; }

  /// Returns the predicted remaining wall time [s]; empty where the step at
  /// work takes longer than predicted, and its share is not known. A known
  /// share that promises a longer time than the prediction replaces it.
  ///
  /// @param elapsed     wall time since the beginning [s]
  /// @param since_last  of this, since the last finished step [s]
  std::optional<double> seconds_left(double elapsed, double since_last,
                                     const StepAtWork& step = {}) const;

private:
  double weight(const std::string& method) const;

  std::map<std::string, double> weights_; ///< of one step [s]
  int n_steps_ = 0;
  int n_done_ = 0;
  double total_ = 0.0; ///< predicted CPU time of the steps to compute [s]
  double done_ = 0.0;  ///< of the computed ones [s]
  double wall_per_cpu_;
};

/// Formats a time for the reader: "8 s", "4 min", "2.5 h".
std::string duration_text(double seconds);

/// Formats what is left: "about 4 min left", or "longer than predicted".
std::string remaining_text(const std::optional<double>& seconds);

} // namespace asperity::run
