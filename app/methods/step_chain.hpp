#pragma once

// The cached load steps of one method on one realisation.

#include "app/cache/cache.hpp"
#include "app/methods/cached_step.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity::app {

class StepChain {
public:
  /// @param cache  must outlive the chain
  /// @param keys   one key per step, see CaseKeys::steps()
  StepChain(Cache& cache, std::vector<std::string> keys)
      : cache_(cache), keys_(std::move(keys)) {}

  bool is_on() const { return cache_.is_on(); }

  /// Returns true if an entry for the step exists. The entry is not opened.
  bool has(std::size_t step) const;

  /// Reads a cached step. Returns nothing if the entry lacks fields or a
  /// section that are needed.
  std::optional<CachedStep> read(std::size_t step, bool needs_maps,
                                 bool needs_section);

  /// Caches a step. Maps and states that ranks hold pass through rank 0 by
  /// rows, unless the cache has no room for them.
  ///
  /// @param state  StepSolver::state() after the step. The state after the
  ///               previous step is removed, because a run continues only from
  ///               the last one.
  void keep(std::size_t step, const CachedStep& kept,
            const SavedState& state = {});

  /// Returns the solver state after a step; nothing if there is none.
  std::optional<StateReader> state_after(std::size_t step);

private:
  Cache& cache_;
  std::vector<std::string> keys_;
};

} // namespace asperity::app
