#pragma once

// The largest of several numbers, of which none may be a NaN unnoticed.

#include <cmath>
#include <span>

namespace asperity {

/// The larger of two numbers; NaN if either is one, where std::max would keep
/// its first argument.
inline double maximum(double first, double second) {
  return first > second || std::isnan(first) ? first : second;
}

/// max_i |values_i|; NaN if any value is one, 0 if there are none.
inline double largest_magnitude(std::span<const double> values) {
  double largest = 0.0;
  for (const double value : values)
    largest = maximum(largest, std::abs(value));
  return largest;
}

} // namespace asperity
