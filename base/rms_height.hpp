#pragma once

// This file defines the rms height, for surfaces and for tolerances that are
// relative to it.

#include <cmath>
#include <numeric>
#include <span>

namespace asperity {

/// sqrt <(h - <h>)^2> over the nodes, in the unit of h; adding a constant to
/// all heights does not change it. NaN if there are no heights or if one is not
/// finite.
inline double rms_height(std::span<const double> heights) {
  const auto count = static_cast<double>(heights.size());
  const double mean =
      std::accumulate(heights.begin(), heights.end(), 0.0) / count;
  double square = 0.0;
  for (const double height : heights)
    square += (height - mean) * (height - mean);
  return std::sqrt(square / count);
}

} // namespace asperity
