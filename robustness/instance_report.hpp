#pragma once

// This file describes the outcome of an instance, and the line by which it is
// sent from one process to another.

#include <string>

namespace asperity::robustness {

enum class Outcome {
  verified, ///< converged, and every check passes
  refused,  ///< not started, for a reason that names argument, value and range
  // The following outcomes are failures; none of them should occur.
  check_failed,
  gave_up,   ///< a solution did not converge
  threw,     ///< an exception that is not a refusal
  timed_out, ///< exceeded the time limit
  crashed,   ///< the process died
};

constexpr int n_outcomes = 7;

bool is_good(Outcome outcome);
std::string name_of(Outcome outcome);

/// The report on one instance.
struct InstanceReport {
  int index = 0;
  Outcome outcome = Outcome::verified;
  std::string check; ///< name of the failed check; empty if none failed
  /// Reason of a refusal, note of the solver or finding of the check.
  std::string reason;
  int iterations = 0; ///< total over all steps
  double area = 0.0;  ///< counted area at the load of the instance [1]
  /// Mean gap at the load of the instance over h_rms [1]
  double reduced_gap = 0.0;
  /// Tolerance of reduced_gap; not sent to other processes [1]
  double reduced_tolerance = 0.0;
  bool has_pair = false;
  bool has_same_bits = false; ///< fields of the pair, scaled, are bitwise equal
  /// Difference of the mean gaps, in units of the tolerance [1]
  double pair_difference = 0.0;
  double seconds = 0.0; ///< CPU time
};

/// Converts a report to one line of JSON and back.
/// @throws nlohmann::json::exception  the line has another format
std::string to_line(const InstanceReport& report);
InstanceReport from_line(const std::string& line);

} // namespace asperity::robustness
