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
  run::CaseOptions options;    ///< of maps and bodies
  std::string against;         ///< map of the face on the first one; "": none
  bool is_periodic = false;    ///< --edges periodic
  std::string tip_radius;      ///< "10 nm"; empty: not known
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

/// Adds the map of a face that lies on that of the input, turned over along x:
///
///     h(x, y) = h_1(x, y) + h_2(L - x, y)
///
/// over the part that both have, from the first point on. The gap between two
/// rough elastic faces is that of a rigid face with the sum of their heights
/// and a flat one with the contact modulus of both bodies (Johnson, Contact
/// Mechanics, 1985, chapter 4).
/// @throws input::InputError  one of them is no map, their spacings differ by
///                            more than 1e-3, or only one is periodic
void put_against(SurfaceInput& input, const SurfaceInput& other);

} // namespace asperity::cli
