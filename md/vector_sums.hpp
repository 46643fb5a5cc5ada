#pragma once

// The sum over all unknowns that every minimiser takes, in a fixed order.

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

} // namespace asperity::md
