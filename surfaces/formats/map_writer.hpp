#pragma once

// Writes height maps in the formats of other programs. What is written can be
// read again by read_scan.

#include "surfaces/maps/height_map.hpp"

#include <filesystem>
#include <string>

namespace asperity::surfaces {

/// The endings of write_map for messages and help texts: ".npy, .h5, ...".
std::string written_map_endings();

/// What the values of a written map are.
struct MapQuantity {
  std::string name = "heights";
  std::string unit = "m"; ///< SI
};

/// Writes a map in the format of the ending, atomically:
///
///     .npy  values, float64, rows along y; lengths are not stored
///     .h5   dataset /heights, or the name of the quantity, with the attributes
///           unit, length and length_y
///     .gwy  one channel of Gwyddion's native format
///     .txt  Gwyddion's text matrix, whose numbers read back bitwise equal
///     .x3p  ISO 5436-2, a surface with incremental axes and float64 heights;
///           a length only
///
/// @param title  of the channel, one line; .npy and .x3p do not store it
/// @throws input::InputError   another ending, the message lists these; a
///                             quantity that is no length as .x3p
/// @throws std::system_error  the file cannot be written; std::runtime_error if
///                            a library fails
void write_map(const std::filesystem::path& path, const HeightMap& map,
               const std::string& title, const MapQuantity& quantity = {});

/// Returns a file with one channel, rows in the order of the map, lengths and
/// heights in metres.
/// @param title  of the channel, without NUL
/// @see  Gwyddion User Guide, "Gwyddion Native Data File Format"
std::string gwyddion_bytes(const HeightMap& map, const std::string& title,
                           const std::string& unit = "m");

/// The bytes of a Gwyddion text matrix.
std::string gwyddion_text(const HeightMap& map, const std::string& title,
                          const std::string& unit = "m");

} // namespace asperity::surfaces
