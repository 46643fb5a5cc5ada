#pragma once

// Maps that are read by pieces, whether they are in memory or were left in a
// result file.

#include "base/array_memory.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace asperity::results {

/// Which maps a reader leaves in the file.
enum class MapsInFile { none, large };

/// Nodes from which on a map is large.
inline constexpr std::size_t large_map = std::size_t{1} << 20;

/// Values of a stored map that are in memory at a time, a chunk of the file.
inline constexpr std::size_t values_at_a_time = std::size_t{1} << 22;

/// A map that was left in a file.
struct StoredMap {
  std::size_t rows = 0;
  std::size_t columns = 0;
  /// Reads `count` rows from the row `first` on, x fastest.
  /// @throws input::InputError  the file has no such map any more
  std::function<std::vector<double>(std::size_t first, std::size_t count)> read;
  std::size_t at_a_time = values_at_a_time; ///< values in memory, >= 1
};

/// The values of a map, x fastest. The map must outlive the view.
class MapView {
public:
  MapView() = default;

  MapView(std::span<const double> values) : values_(values) {}

  MapView(const std::vector<double>& values) : values_(values) {}

  MapView(const StoredMap& map) : stored_(map.read ? &map : nullptr) {}

  std::size_t size() const {
    return stored_ != nullptr ? stored_->rows * stored_->columns
                              : values_.size();
  }

  bool empty() const { return size() == 0; }

  bool is_stored() const { return stored_ != nullptr; }

  /// Number of values that are read together: whole rows, an even number of
  /// them; all values of a map in memory.
  std::size_t piece() const {
    if (stored_ == nullptr)
      return size();
    const std::size_t pairs = stored_->at_a_time / (2 * stored_->columns);
    return 2 * stored_->columns * std::max(std::size_t{1}, pairs);
  }

  /// Some adjacent values.
  /// @param read  holds them if they come from a file
  std::span<const double> values(std::size_t first, std::size_t count,
                                 std::vector<double>& read) const {
    if (stored_ == nullptr)
      return values_.subspan(first, count);
    const std::size_t width = stored_->columns;
    const std::size_t row = first / width;
    free_memory(read); // before the next values are read
    read = stored_->read(row, (first + count + width - 1) / width - row);
    return std::span<const double>(read).subspan(first - row * width, count);
  }

  /// All values.
  std::vector<double> whole() const {
    if (stored_ != nullptr)
      return stored_->read(0, stored_->rows);
    return {values_.begin(), values_.end()};
  }

private:
  std::span<const double> values_;
  const StoredMap* stored_ = nullptr;
};

/// The view of a map that is in memory or in a file.
inline MapView view_of(const std::vector<double>& values,
                       const StoredMap& stored) {
  return stored.read ? MapView(stored) : MapView(values);
}

/// Calls take(first, values of each map) for pieces of maps of equal size, from
/// the first value to the last.
/// @param piece  number of values, the last piece may have fewer
template <std::size_t n, class Take>
void each_piece(const std::array<MapView, n>& maps, std::size_t piece,
                const Take& take) {
  std::array<std::vector<double>, n> read;
  std::array<std::span<const double>, n> values;
  const std::size_t size = maps[0].size();
  for (std::size_t first = 0; first < size; first += piece) {
    for (std::size_t k = 0; k < n; ++k)
      values[k] = maps[k].values(first, std::min(piece, size - first), read[k]);
    take(first, values);
  }
}

/// The same in pieces of whole pairs of rows of the first map that is not in
/// memory.
template <std::size_t n, class Take>
void each_piece(const std::array<MapView, n>& maps, const Take& take) {
  std::size_t piece = maps[0].size();
  for (const MapView& map : maps)
    piece = std::min(piece, map.piece());
  each_piece(maps, piece, take);
}

/// Calls take(values) for pieces of a map, in order.
template <class Take>
void each_piece(const MapView& map, const Take& take) {
  each_piece(std::array{map},
             [&](std::size_t, const auto& values) { take(values[0]); });
}

/// The least and the largest value of a map.
struct Extremes {
  double least = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
};

inline Extremes extremes_of(const MapView& map) {
  Extremes found;
  each_piece(map, [&](std::span<const double> values) {
    const auto [least, largest] = std::ranges::minmax(values);
    found.least = std::min(found.least, least);
    found.largest = std::max(found.largest, largest);
  });
  return found;
}

} // namespace asperity::results
