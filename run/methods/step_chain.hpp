#pragma once

// Finished load steps and tables of studies in the cache. An entry is the
// record that the journal of a result has of the same change.

#include "results/storage/change.hpp"
#include "run/methods/cache/cache.hpp"
#include "run/methods/step_solver.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity::methods {

/// Reads a change from the cache. Its maps remain in the entry until they are
/// read. An entry that does not have the layout of keep_change() is removed.
std::optional<results::Change> kept_change(Cache& cache, const std::string& key,
                                           const std::string& kind);

/// Caches a change, unless the cache has no room for it.
void keep_change(Cache& cache, const std::string& key, const std::string& kind,
                 const results::Change& change);

/// The cached load steps of one method on one realisation.
class StepChain {
public:
  /// @param cache  must outlive the chain
  /// @param keys   one key per step, see CaseKeys::steps()
  StepChain(Cache& cache, std::vector<std::string> keys)
      : cache_(cache), keys_(std::move(keys)) {}

  bool is_on() const { return cache_.is_on(); }

  /// Returns true if an entry for the step exists. The entry is not opened.
  bool has(std::size_t step) const;

  /// Reads a cached step: a change of one method with one row. Returns nothing
  /// if the entry lacks fields or a section that are needed.
  std::optional<results::Change> read(std::size_t step, bool needs_maps,
                                      bool needs_section);

  /// Caches a step.
  ///
  /// @param state  StepSolver::state() after the step. The state after the
  ///               previous step is removed, because a run continues only from
  ///               the last one.
  void keep(std::size_t step, const results::Change& change,
            std::span<const double> state = {});

  /// Returns the solver state after a step; nothing if there is none.
  std::optional<std::vector<double>> state_after(std::size_t step);

private:
  Cache& cache_;
  std::vector<std::string> keys_;
};

} // namespace asperity::methods
