#pragma once

// Converts solved load steps and tables of studies to the bytes of cache
// entries and back.

#include "app/cache/cache.hpp"
#include "app/methods/step_solver.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace asperity::app {

/// One load step as it was computed, with the cost of its set-up.
struct CachedStep {
  StepAnswer answer;           ///< fields are empty if they were not saved
  double setup_cpu_time = 0.0; ///< of the method on this realisation [s]
  std::string found_at_setup;  ///< see StepSolver::found_at_setup()

  bool has_maps() const { return !answer.pressure.empty() || answer.rows; }
};

/// The entry of a step: its length without maps, this part, and the maps in
/// single precision as in a result file, which come by rows if ranks hold them.
/// All other numbers are restored bit by bit.
struct StepEntry {
  std::uintmax_t size = 0; ///< [B]
  BytePieces bytes;
};

/// @param step  must outlive the result
StepEntry entry_of(const CachedStep& step);

/// Converts to the bytes of a cache entry.
std::string bytes_of(const results::Table& table);

/// Converts from the bytes of a cache entry. Returns nothing if the bytes were
/// not written by the functions above. Large maps are left in the entry, and
/// the answer reads them by rows.
std::optional<CachedStep> cached_step(CacheEntry entry);
std::optional<results::Table> kept_table(std::string_view bytes);

/// The entry of a state.
StepEntry entry_of(const SavedState& state);
std::optional<StateReader> kept_state(CacheEntry entry);

} // namespace asperity::app
