#pragma once

// How a scene ended, and the line it is carried in from one process to another.

#include <string>

namespace asperity::robustness {

enum class Outcome {
  verified, ///< converged, and every check holds
  refused,  ///< not begun, with a reason that names argument, value and range
  // What follows is everything else, of which there is to be none.
  check_failed,
  gave_up,   ///< the numerics did not converge
  threw,     ///< an exception that is no refusal
  timed_out, ///< stopped by the clock
  crashed,   ///< the process died
};

constexpr int n_outcomes = 7;

bool is_good(Outcome outcome);
std::string name_of(Outcome outcome);

/// What is told of a scene.
struct SceneReport {
  int index = 0;
  Outcome outcome = Outcome::verified;
  std::string check;  ///< that failed; empty otherwise
  std::string reason; ///< refusal, note of the solver or finding of the check
  int iterations = 0; ///< of all steps together
  double area = 0.0;  ///< counted, at the scene's load [1]
  double reduced_gap = 0.0; ///< mean gap at the scene's load over h_rms [1]
  double reduced_tolerance = 0.0; ///< of that; in this process alone [1]
  bool has_twin = false;
  bool has_same_bits = false;   ///< the twin's fields, scaled, to the bit
  double twin_difference = 0.0; ///< of the mean gaps, over the tolerance [1]
  double seconds = 0.0;         ///< CPU time
};

/// One line of JSON and back. @throws nlohmann::json::exception  another line
std::string to_line(const SceneReport& report);
SceneReport from_line(const std::string& line);

} // namespace asperity::robustness
