#pragma once

// Shows the progress of a run: a bar on a terminal, one line per step in a
// pipe. The class owns the clock of the run.

#include "results/types/result.hpp"

#include <chrono>
#include <mutex>
#include <string>

namespace asperity::app {

/// Shows the progress. The class is thread-safe.
class Progress {
public:
  /// @param n_steps          total number of steps to do
  /// @param contact_modulus  E* [Pa], unit of the displayed pressures
  Progress(int n_steps, double contact_modulus);

  ~Progress(); ///< removes the bar

  /// @param rms_height  h_rms [m], unit of the displayed gaps
  void step_done(const std::string& method, int realization,
                 const results::CurvePoint& point, double rms_height);

  /// Reports steps that an earlier run computed.
  void steps_kept(const std::string& method, int realization, int n_steps);

  /// Reports the state of an unfinished step. It is shown on a terminal only, a
  /// few times per second.
  ///
  /// @param energy    [J]
  /// @param residual  as defined by the method
  void at_work(const std::string& method, int realization, int evaluations,
               double energy, double residual);

private:
  using Clock = std::chrono::steady_clock;

  /// Draws the bar and the counters without a line break.
  void draw_head() const;
  void draw_bar(const std::string& method, int realization,
                const results::CurvePoint& point);

  std::mutex mutex_;
  int n_steps_;
  int n_done_ = 0;
  double contact_modulus_;
  bool is_terminal_;
  Clock::time_point start_;
  Clock::time_point last_drawn_;
};

} // namespace asperity::app
