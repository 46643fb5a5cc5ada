#pragma once

// Which points of a map have no height.

#include "surfaces/formats/scan.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace asperity::surfaces::tests_of_formats {

/// 1 for each missing point, else 0.
inline std::vector<char> missing_of(const Scan& scan) {
  std::vector<char> missing;
  for (const double height : scan.map.heights)
    missing.push_back(std::isnan(height) ? 1 : 0);
  return missing;
}

/// The heights, 0 at missing points.
inline std::vector<double> or_zero(const Scan& scan) {
  std::vector<double> heights = scan.map.heights;
  std::ranges::replace_if(
      heights, [](double height) { return std::isnan(height); }, 0.0);
  return heights;
}

} // namespace asperity::surfaces::tests_of_formats
