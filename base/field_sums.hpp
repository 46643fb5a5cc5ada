#pragma once

// Computes sums over all values of a field, in a fixed order.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace asperity {

/// sum_i left_i right_i; the two must have the same size.
inline double dot(std::span<const double> left, std::span<const double> right) {
  double sum = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i)
    sum += left[i] * right[i];
  return sum;
}

/// The arithmetic mean; NaN if there are no values.
inline double mean(std::span<const double> values) {
  double sum = 0.0;
  for (const double value : values)
    sum += value;
  return sum / static_cast<double>(values.size());
}

/// The rms height sqrt <(h - <h>)^2> over the nodes, in the unit of h; adding a
/// constant to all heights does not change it. NaN if there are no heights or
/// if one is not finite.
inline double rms_height(std::span<const double> heights) {
  const double centre = mean(heights);
  double square = 0.0;
  for (const double height : heights)
    square += (height - centre) * (height - centre);
  return std::sqrt(square / static_cast<double>(heights.size()));
}

/// Whether no value is NaN or infinite; true if there are no values.
inline bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values,
                             [](double value) { return std::isfinite(value); });
}

} // namespace asperity
