#pragma once

// Maps that are passed on by rows, so that nobody holds a whole one.

#include "results/types/map_view.hpp"

#include <functional>
#include <span>

namespace asperity::results {

/// Receives the next values of a map, x fastest.
using TakeValues = std::function<void(std::span<const double> values)>;

/// Gives all values of a map to a function, piece by piece from the first row
/// to the last.
using MapRows = std::function<void(const TakeValues& take)>;

/// The rows of a map in memory or in a file, which must outlive the result.
inline MapRows rows_of_map(const MapView& map) {
  return [map](const TakeValues& take) { each_piece(map, take); };
}

} // namespace asperity::results
