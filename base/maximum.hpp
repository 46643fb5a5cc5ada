#pragma once

// Maxima that propagate NaN.

#include <cmath>
#include <span>

namespace asperity {

/// The larger of two numbers; NaN if either is NaN, where std::max would return
/// its first argument.
inline double maximum(double first, double second) {
  return first > second || std::isnan(first) ? first : second;
}

/// max_i |values_i|; NaN if any value is NaN, 0 if there are no values.
inline double largest_magnitude(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values)
    largest = maximum(largest, std::abs(value));
  return largest;
}

} // namespace asperity
