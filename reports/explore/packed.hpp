#pragma once

// Packs tables and maps for a page: compressed (zlib format) and in base64, as
// the browser's own DecompressionStream unpacks them.

#include <string>
#include <string_view>
#include <vector>

namespace asperity::reports {

/// Returns the text compressed, in base64.
std::string packed(std::string_view text);

std::string base64(std::string_view bytes);

/// A map in 2047 steps between its extremes. Step 0 is the least value exactly,
/// and nothing else: a small positive pressure does not become zero.
struct PackedMap {
  double low = 0.0, high = 0.0;             ///< 0 and 0 if no value is finite
  std::string data;                         ///< see packed_map()
  double shown_low = 0.0, shown_high = 0.0; ///< extremes of the map on paper,
                                            ///< which the colours cover
};

constexpr int map_steps = 2047;

/// Packs the values row by row. Each is stored as the difference of its step
/// (2048: not finite) from left + up - upper left, the steps of its neighbours
/// (0 beyond the edge), as 2 d for d >= 0 and -2 d - 1 for d < 0; first the
/// lower bytes of all values, then the upper ones; then packed(). Most
/// differences of a smooth map are small, and the upper bytes zero.
PackedMap packed_map(const std::vector<double>& values, std::size_t columns);

} // namespace asperity::reports
