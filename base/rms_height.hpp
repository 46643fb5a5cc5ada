#pragma once

// The one definition of the rms height, for surfaces and for the tolerances
// that are a share of it.

#include <cmath>
#include <numeric>
#include <span>

namespace asperity {

/// sqrt <(h - <h>)^2> over the nodes, in the unit of h: no constant added to
/// all heights changes it. NaN for no heights or one that is not finite.
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
