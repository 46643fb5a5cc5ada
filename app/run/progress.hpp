#pragma once

// What a user sees while steps are computed: a bar on a terminal, a line a
// step in a pipe. Owns the clock of a run.

#include "results/types/result.hpp"

#include <chrono>
#include <mutex>
#include <string>

namespace asperity::app {

/// Safe to call from any thread.
class Progress {
public:
  /// @param n_steps          to be done in all
  /// @param contact_modulus  E* [Pa], by which pressures are shown
  Progress(int n_steps, double contact_modulus);

  ~Progress(); ///< takes the bar away

  /// @param rms_height  h_rms [m], by which gaps are shown
  void step_done(const std::string& method, int realization,
                 const results::CurvePoint& point, double rms_height);

  /// Steps that an earlier run computed.
  void steps_kept(const std::string& method, int realization, int n_steps);

  /// A step is at work; shown on a terminal, a few times a second.
  /// @param energy    [J]
  /// @param residual  as the method measures it
  void at_work(const std::string& method, int realization, int evaluations,
               double energy, double residual);

private:
  using Clock = std::chrono::steady_clock;

  /// The bar and what is counted, without a line's end.
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
