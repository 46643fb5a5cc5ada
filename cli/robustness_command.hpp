#pragma once

// `asperity robustness`: runs and verifies the random problem instances of the
// stability matrix and writes the reports.

#include "run/exit_code.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity::cli {

struct RobustnessCommand {
  std::vector<std::string> cases; ///< cases to perturb; none: random
  int instances = 2000; ///< number of instances that match `only`, per case
  std::uint64_t seed = 1;
  std::string only;            ///< see robustness::InstanceFilter
  std::optional<int> instance; ///< run only this instance and print all details
  int threads = 0;             ///< number of processes; 0: all cores
  std::string out = "out/robustness";
};

/// Writes stress.json and stress.csv into `out`; for a case, into
/// the sub-folder with the name of the case.
///
/// @return  exit_not_converged if any instance is neither verified nor
///          refused
run::ExitCode run_robustness(const RobustnessCommand& command);

} // namespace asperity::cli
