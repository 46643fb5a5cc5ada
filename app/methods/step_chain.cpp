#include "app/methods/step_chain.hpp"

namespace asperity::app {

bool StepChain::has(std::size_t step) const {
  return cache_.has(keys_.at(step), entry_kind::step);
}

std::optional<CachedStep> StepChain::read(std::size_t step, bool needs_maps,
                                          bool needs_section) {
  const std::string& key = keys_.at(step);
  const std::optional<std::string> bytes = cache_.read(key, entry_kind::step);
  if (!bytes)
    return std::nullopt;
  std::optional<CachedStep> kept = cached_step(*bytes);
  if (!kept)
    cache_.remove(key, entry_kind::step);
  if (kept && ((needs_maps && !kept->has_maps()) ||
               (needs_section && !kept->answer.section)))
    return std::nullopt;
  return kept;
}

void StepChain::keep(std::size_t step, const CachedStep& kept,
                     const std::vector<double>& state) {
  if (!cache_.is_on())
    return;
  cache_.write(keys_.at(step), entry_kind::step, bytes_of(kept));
  if (state.empty())
    return;
  cache_.write(keys_[step], entry_kind::state, bytes_of(state));
  if (step > 0)
    cache_.remove(keys_[step - 1], entry_kind::state);
}

std::vector<double> StepChain::state_after(std::size_t step) {
  const std::optional<std::string> bytes =
      cache_.read(keys_.at(step), entry_kind::state);
  return bytes ? kept_numbers(*bytes).value_or(std::vector<double>())
               : std::vector<double>();
}

} // namespace asperity::app
