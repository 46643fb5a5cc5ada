#include "app/methods/step_chain.hpp"

namespace asperity::app {

bool StepChain::has(std::size_t step) const {
  return cache_.has(keys_.at(step), entry_kind::step);
}

std::optional<CachedStep> StepChain::read(std::size_t step, bool needs_maps,
                                          bool needs_section) {
  const std::string& key = keys_.at(step);
  std::optional<CacheEntry> entry = cache_.open(key, entry_kind::step);
  if (!entry)
    return std::nullopt;
  std::optional<CachedStep> kept = cached_step(std::move(*entry));
  if (!kept)
    cache_.remove(key, entry_kind::step);
  if (kept && ((needs_maps && !kept->has_maps()) ||
               (needs_section && !kept->answer.section)))
    return std::nullopt;
  return kept;
}

void StepChain::keep(std::size_t step, const CachedStep& kept,
                     const SavedState& state) {
  if (!cache_.is_on())
    return;
  const StepEntry entry = entry_of(kept);
  cache_.write(keys_.at(step), entry_kind::step, entry.size, entry.bytes);
  if (state.count == 0)
    return;
  const StepEntry saved = entry_of(state);
  cache_.write(keys_[step], entry_kind::state, saved.size, saved.bytes);
  if (step > 0)
    cache_.remove(keys_[step - 1], entry_kind::state);
}

std::optional<StateReader> StepChain::state_after(std::size_t step) {
  std::optional<CacheEntry> entry =
      cache_.open(keys_.at(step), entry_kind::state);
  return entry ? kept_state(std::move(*entry)) : std::nullopt;
}

} // namespace asperity::app
