#pragma once

// Writes height maps in the native format of Gwyddion (.gwy).

#include "surfaces/maps/height_map.hpp"

#include <string>

namespace asperity::surfaces {

/// Returns a file with one channel, rows in the order of the map, lengths and
/// heights in metres.
/// @param title  of the channel, without NUL
/// @see  Gwyddion User Guide, "Gwyddion Native Data File Format"
std::string gwyddion_bytes(const HeightMap& map, const std::string& title,
                           const std::string& unit = "m");

} // namespace asperity::surfaces
