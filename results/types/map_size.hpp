#pragma once

// The size check of functions that take complete maps.

#include "base/require.hpp"

#include <cstddef>
#include <string>

namespace asperity::results {

/// Checks the size of a map.
/// @throws std::domain_error  the map is empty or does not have `expected`
///                            values
inline void require_size(const std::string& name, std::size_t size,
                         std::size_t expected) {
  if (size != expected || size == 0)
    refuse_argument(name + ".size()", static_cast<double>(size),
                    expected == 0 ? "at least 1"
                                  : "equal to " + std::to_string(expected));
}

} // namespace asperity::results
