#pragma once

// One method on one realisation as the cache knows it, step after step.

#include "app/cache/cache.hpp"
#include "app/methods/kept_step.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace asperity::app {

class StepChain {
public:
  /// @param cache  outlives the chain
  /// @param keys   one a step, CaseKeys::steps()
  StepChain(Cache& cache, std::vector<std::string> keys)
      : cache_(cache), keys_(std::move(keys)) {}

  /// True if the step seems to be there; it is not opened.
  bool has(std::size_t step) const;

  /// An entry without the maps or the section that are needed is none.
  std::optional<KeptStep> read(std::size_t step, bool needs_maps,
                               bool needs_section);

  /// @param state  StepSolver::state() behind the step; the one of the step
  ///               before goes, because only the last is gone on from
  void keep(std::size_t step, const KeptStep& kept,
            const std::vector<double>& state = {});

  /// Empty if there is none.
  std::vector<double> state_after(std::size_t step);

private:
  Cache& cache_;
  std::vector<std::string> keys_;
};

} // namespace asperity::app
