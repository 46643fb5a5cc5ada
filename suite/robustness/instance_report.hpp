#pragma once

// Describes the outcome of an instance, and the line by which it is sent from
// one process to another.

#include <functional>
#include <optional>
#include <string>

namespace asperity::robustness {

enum class Outcome {
  verified, ///< converged, and every check passes
  refused,  ///< not started, for a reason that names argument, value and range
  // The following outcomes are failures; none of them should occur.
  check_failed,
  not_converged, ///< a solution did not converge
  threw,         ///< an exception that is not a refusal
  timed_out,     ///< exceeded the time limit
  crashed,       ///< the process died
};

constexpr int n_outcomes = 7;

bool is_good(Outcome outcome);
std::string name_of(Outcome outcome);

/// How a step without a converged solution counts. A note that states what is
/// allowed describes a problem without a solution, which is refused. That
/// another linear solver must be used has to be so: it solves the step.
/// @param note            of the solver; the failure of the direct solver is
///                        added to it
/// @param solve_directly  solves the step by the direct solver and returns its
///                        note if it does not converge; called only if the note
///                        advises it
Outcome outcome_of_note(
    std::string& note,
    const std::function<std::optional<std::string>()>& solve_directly);

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
  double gap_scale = 0.0; ///< h_rms of the first surface; not sent [m]
  bool has_pair = false;
  bool has_same_bits = false; ///< fields of the pair, scaled, are bitwise equal
  /// Difference of the mean gaps, in units of the tolerance [1]
  double pair_difference = 0.0;
  double seconds = 0.0; ///< CPU time
};

/// Converts a report to one line of JSON and back.
/// @throws nlohmann::ordered_json::exception  the line has another format
std::string to_line(const InstanceReport& report);
InstanceReport from_line(const std::string& line);

} // namespace asperity::robustness
