#pragma once

// Two sums over all unknowns that every minimiser takes, in a fixed order.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace asperity::md {

/// sum_i left_i right_i; both of one size.
inline double dot(std::span<const double> left, std::span<const double> right) {
  double sum = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i)
    sum += left[i] * right[i];
  return sum;
}

/// max_i |values_i|, 0 if there are none.
inline double largest(std::span<const double> values) {
  double most = 0.0;
  for (const double value : values)
    most = std::max(most, std::abs(value));
  return most;
}

} // namespace asperity::md
