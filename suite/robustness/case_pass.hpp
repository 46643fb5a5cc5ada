#pragma once

// One pass of a case: its method on every realisation, load step by load step,
// each of which is verified. Internal to the module.

#include "input/types/case.hpp"
#include "suite/robustness/instance_report.hpp"
#include "suite/robustness/verify.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::robustness {

/// What a pass has found, step after step of one realisation after another.
struct Pass {
  std::vector<std::vector<double>> pressures; ///< [Pa]
  std::vector<std::vector<double>> gaps;      ///< [m]
  std::vector<StepSummary> steps;
  std::vector<double> unknowns; ///< of a full block
};

/// A case and the one method of it that is run.
struct MethodOfCase {
  const cases::Case& contact_case;
  const cases::MethodSpec& method;
};

/// How a pass is made.
struct PassSettings {
  int threads = 1;
  /// Of a full block: the same case with a factorised matrix, which tells
  /// whether a step that does not converge has a solution; null: none.
  const cases::MethodSpec* direct = nullptr;
};

/// Solves and verifies. The pass is empty if the report says why not.
Pass run_pass(const MethodOfCase& what, const PassSettings& settings,
              InstanceReport& report);

/// Evaluates a theory and verifies each row. Fills the report.
void run_theory(const MethodOfCase& what, InstanceReport& report);

/// Whether the second pass of a full block can be compared by its energy, and
/// whether the fields of the method are those of contact points.
bool is_laterally_uniform(const MethodOfCase& what);
bool has_nodal_fields(const MethodOfCase& what);

/// Writes a failure into the report.
void fail(InstanceReport& report, const Failure& failure);

/// Runs the instance as a case file through the program after the library has
/// solved it, and verifies that the rows of the result file lie in their ranges
/// and that the mean gap is the same. A refusal by the program (exit code 2) is
/// thrown as std::domain_error.
/// @param folder  with case.toml and its map
struct ProgramRun {
  std::filesystem::path folder;
  std::filesystem::path program;
  std::string path; ///< label of the axis
  int threads = 1;
  bool is_flawed = false;
};

void run_program(const ProgramRun& run, InstanceReport& report);

} // namespace asperity::robustness
