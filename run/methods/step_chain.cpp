#include "run/methods/step_chain.hpp"

#include "input/input_error.hpp"

namespace asperity::methods {

std::optional<results::Change> kept_change(Cache& cache, const std::string& key,
                                           const std::string& kind) {
  const std::optional<FileBytes> entry = cache.open(key, kind);
  if (!entry)
    return std::nullopt;
  try {
    return results::change_in(*entry);
  } catch (const input::InputError&) {
    cache.remove(key, kind);
    return std::nullopt;
  }
}

void keep_change(Cache& cache, const std::string& key, const std::string& kind,
                 const results::Change& change) {
  const results::Record record = results::record_of(change);
  cache.write(key, kind, record.size, record.bytes);
}

bool StepChain::has(std::size_t step) const {
  return cache_.has(keys_.at(step), entry_kind::step);
}

std::optional<results::Change>
StepChain::read(std::size_t step, bool needs_maps, bool needs_section) {
  std::optional<results::Change> kept =
      kept_change(cache_, keys_.at(step), entry_kind::step);
  if (!kept || kept->methods.size() != 1 ||
      kept->methods[0].points.size() != 1 ||
      (needs_maps && kept->methods[0].fields.empty()) ||
      (needs_section && kept->tables.empty()))
    return std::nullopt;
  return kept;
}

void StepChain::keep(std::size_t step, const results::Change& change,
                     std::span<const double> state) {
  if (!cache_.is_on())
    return;
  keep_change(cache_, keys_.at(step), entry_kind::step, change);
  if (state.empty())
    return;
  cache_.write(
      keys_[step], entry_kind::state, state.size_bytes(),
      [&state](const TakeBytes& take) {
        take({reinterpret_cast<const char*>(state.data()), state.size_bytes()});
      });
  if (step > 0)
    cache_.remove(keys_[step - 1], entry_kind::state);
}

std::optional<std::vector<double>> StepChain::state_after(std::size_t step) {
  const std::optional<FileBytes> entry =
      cache_.open(keys_.at(step), entry_kind::state);
  if (!entry || entry->size() % sizeof(double) != 0)
    return std::nullopt;
  std::vector<double> state(entry->size() / sizeof(double));
  entry->read(0, {reinterpret_cast<char*>(state.data()),
                  state.size() * sizeof(double)});
  return state;
}

} // namespace asperity::methods
