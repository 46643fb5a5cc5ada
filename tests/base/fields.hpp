#pragma once

// The difference of two fields, for tests: a number that is not finite and an
// empty field never count as a small difference.

#include "base/maximum.hpp"

#include <cstddef>
#include <limits>
#include <span>

namespace asperity::tests {

/// max_i |a_i - b_i|; NaN where a difference is NaN, infinity for fields that
/// are empty or of unequal sizes.
inline double largest_difference(std::span<const double> a,
                                 std::span<const double> b) {
  if (a.empty() || a.size() != b.size())
    return std::numeric_limits<double>::infinity();
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = maximum(largest, std::abs(a[i] - b[i]));
  return largest;
}

} // namespace asperity::tests
