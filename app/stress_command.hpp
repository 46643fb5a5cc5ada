#pragma once

// `asperity stress`: the stability matrix, run, written and judged.

#include "app/exit_code.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity::app {

struct StressCommand {
  std::vector<std::string> cases; ///< perturbed; none: everything is drawn
  int scenes = 2000;              ///< that pass `only`, of each case
  std::uint64_t seed = 1;
  std::string only;         ///< see stress::SceneFilter
  std::optional<int> scene; ///< this one alone, and everything about it
  int threads = 0;          ///< processes; 0: all cores
  std::string out = "out/stress";
};

/// Writes stress.html, stress.json and stress.csv into `out` (of a case, into a
/// folder of its name in it).
/// @return  exit_numerics_gave_up if any scene is neither verified nor refused
ExitCode run_stress(const StressCommand& command);

} // namespace asperity::app
