#pragma once

// Turns the values of a swept key into positions, labels and colours of a
// figure.

#include "input/sweeps/sweep.hpp"

#include <string>
#include <vector>

namespace asperity::reports {

/// A swept key as the axis of a figure.
struct FigureAxis {
  std::string title; ///< "surface.length [um]"
  /// Position of each value: the number itself if all values are numbers, or
  /// numbers with units of one dimension, in that of the first; otherwise 0, 1,
  /// 2, ...
  std::vector<double> positions;
  std::vector<std::string> labels; ///< without quotes: "14 nm", "none"
  bool is_numeric = false;
  bool is_log = false; ///< the positions span more than a factor of 20, all > 0
};

FigureAxis axis_of(const cases::SweptKey& key);

/// Returns colour i of n of a sequential scale from dark blue to yellow, as
/// "#rrggbb"; it keeps its order in grey print and for colour-blind readers.
std::string scale_color(std::size_t i, std::size_t n);

/// Returns the ticks of an axis that is not numeric, at 0, 1, 2, ..., with
/// their markup.
std::vector<std::pair<double, std::string>> named_ticks(const FigureAxis& axis);

} // namespace asperity::reports
