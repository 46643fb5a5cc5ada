#pragma once

// Reads the inputs of `asperity surface`: a map file, a line scan, or the
// surface of a case, each levelled.

#include "run/cli/command_line.hpp"
#include "surfaces/analysis/line_scan.hpp"
#include "surfaces/maps/height_map.hpp"

#include <string>
#include <variant>
#include <vector>

namespace asperity::cli {

/// Options of `asperity surface`.
struct SurfaceCommand {
  std::vector<std::string> inputs; ///< map files, line scans or cases
  std::vector<std::string> overrides;
  std::string level = "plane"; ///< [surface] level of a file
  bool is_periodic = false;    ///< --edges periodic
  std::string length;          ///< "20 um"; empty: the file states it
  std::string height_unit;     ///< "nm"; empty: the file states it
  std::string missing_value;   ///< "-9999"; empty: no number marks a point
  std::string length_unit;     ///< "um", of positions; empty: stated or none
  std::string channel;         ///< title or number; empty: the one with heights
  std::string tip_radius;      ///< "10 nm"; empty: not known
  std::string contact_modulus; ///< "2 GPa"; empty: no theory
  double gamma = 0.4;          ///< of the theory, as `run MAP` sets it
  std::string out;             ///< empty: out/<name>
  std::string write;           ///< file to convert the map to
  std::string field;           ///< of a result: pressure, gap or heights
  bool is_whole_cell = false;  ///< the map with its mirror images
  std::string method;          ///< whose field; empty: the first with fields
  int step = -1;               ///< of the field; negative: the last saved one
  bool lists_channels = false; ///< print the channels of files, no more
  bool has_no_report = false;
  ReportForms forms; ///< of the report
};

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
