#pragma once

// A finished step and a study's table as the bytes the cache keeps.

#include "app/methods/step_solver.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::app {

/// One load step as it was computed, with what it took to get there.
struct KeptStep {
  StepAnswer answer;           ///< maps empty where they were not kept
  double setup_cpu_time = 0.0; ///< of its method on its realisation [s]
  std::string found_at_setup;  ///< as StepSolver::found_at_setup()

  bool has_maps() const { return !answer.pressure.empty(); }
};

/// Every number comes back bit by bit, those of maps as the single precision
/// that a result file has.
std::string bytes_of(const KeptStep& step);
std::string bytes_of(const results::Table& table);
std::string bytes_of(const std::vector<double>& numbers);

/// Nothing if the bytes are not what the functions above write.
std::optional<KeptStep> kept_step(std::string_view bytes);
std::optional<results::Table> kept_table(std::string_view bytes);
std::optional<std::vector<double>> kept_numbers(std::string_view bytes);

} // namespace asperity::app
