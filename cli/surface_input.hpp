#pragma once

// Reads the inputs of `asperity surface`: a map file, a line scan, or the
// surface of a case, each levelled.

#include "cli/surface_command.hpp"
#include "surfaces/analysis/line_scan.hpp"
#include "surfaces/maps/height_map.hpp"

#include <string>
#include <variant>
#include <vector>

namespace asperity::cli {

/// A map as it is analysed.
struct SurfaceMap {
  surfaces::HeightMap map;
  bool is_periodic = false;
  std::vector<std::string> warnings = {}; ///< of a measured map
};

/// One input.
struct SurfaceInput {
  std::string name;   ///< without folders, for tables and folders
  std::string origin; ///< how it was read and levelled, a sentence
  std::variant<SurfaceMap, surfaces::LineScan> heights;
};

/// Reads one input. A regular file whose name does not end with .toml is a map
/// or a line scan, anything else a case. A file is read as a case of kind
/// "measured" would read it, so that the overrides surface.* apply.
/// @throws input::InputError  it is neither, or cannot be read
SurfaceInput read_surface_input(const std::string& word,
                                const SurfaceCommand& command);

} // namespace asperity::cli
