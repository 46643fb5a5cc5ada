#pragma once

// Converts solved load steps and tables of studies to the bytes of cache
// entries and back.

#include "app/methods/step_solver.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::app {

/// One load step as it was computed, with the cost of its set-up.
struct CachedStep {
  StepAnswer answer;           ///< fields are empty if they were not saved
  double setup_cpu_time = 0.0; ///< of the method on this realisation [s]
  std::string found_at_setup;  ///< see StepSolver::found_at_setup()

  bool has_maps() const { return !answer.pressure.empty(); }
};

/// Converts to the bytes of a cache entry. All numbers are restored bit by bit,
/// except that maps are stored in single precision as in a result file.
std::string bytes_of(const CachedStep& step);
std::string bytes_of(const results::Table& table);
std::string bytes_of(const std::vector<double>& numbers);

/// Converts from the bytes of a cache entry. Returns nothing if the bytes were
/// not written by the functions above.
std::optional<CachedStep> cached_step(std::string_view bytes);
std::optional<results::Table> kept_table(std::string_view bytes);
std::optional<std::vector<double>> kept_numbers(std::string_view bytes);

} // namespace asperity::app
