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

/// The rows of a map in memory, which must outlive the result.
inline MapRows rows_of_map(std::span<const double> map) {
  return [map](const TakeValues& take) { take(map); };
}

/// The same of a map that was left in a file.
inline MapRows rows_of_map(const StoredMap& map) {
  return
      [view = MapView(map)](const TakeValues& take) { each_piece(view, take); };
}

/// The maps of one load step.
struct FieldRows {
  int step = 0;
  double nominal_pressure = 0.0; ///< [Pa]
  MapRows pressure;              ///< [Pa] >= 0
  MapRows gap;                   ///< [m]
};

} // namespace asperity::results
