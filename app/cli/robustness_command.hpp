#pragma once

// `asperity robustness`: the stability matrix, run, written and judged.

#include "app/run/exit_code.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity::app {

struct RobustnessCommand {
  std::vector<std::string> cases; ///< perturbed; none: everything is drawn
  int scenes = 2000;              ///< that pass `only`, of each case
  std::uint64_t seed = 1;
  std::string only;         ///< see robustness::SceneFilter
  std::optional<int> scene; ///< this one alone, and everything about it
  int threads = 0;          ///< processes; 0: all cores
  std::string out = "out/robustness";
};

/// Writes stress.html, stress.json and stress.csv into `out` (of a case, into a
/// folder of its name in it).
/// @return  exit_numerics_gave_up if any scene is neither verified nor refused
ExitCode run_robustness(const RobustnessCommand& command);

} // namespace asperity::app
