#pragma once

// What a user sees while steps are computed: a bar on a terminal, a line a
// step in a pipe. Owns the clock of a run.

#include "results/result.hpp"

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

private:
  void draw_bar(const std::string& method, int realization,
                const results::CurvePoint& point);

  std::mutex mutex_;
  int n_steps_;
  int n_done_ = 0;
  double contact_modulus_;
  bool is_terminal_;
  std::chrono::steady_clock::time_point start_;
};

} // namespace asperity::app
