#pragma once

// Reads one channel of an instrument file of any supported format. It defines
// what a reader returns and which questions it is asked.

#include "surfaces/maps/height_map.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// Scales that a case gives for a map because the file does not contain them.
struct MapScale {
  std::optional<double> length;      ///< side length in x [m] > 0
  std::optional<double> height_unit; ///< [m] per unit of the numbers > 0
  /// Side length in y [m] > 0; empty: pixels are square.
  std::optional<double> length_y = {};
  /// [m] per unit of the columns x and y of a list > 0
  std::optional<double> length_unit = {};
};

/// What the numbers of a file are.
struct FileNumbers {
  double unit = 1.0; ///< [m] per unit of the numbers in the file > 0
  /// Number at points without a height, if the header names it.
  std::optional<double> missing = {};
  /// Whether the format has a mark for points without a height, which its
  /// reader knows.
  bool has_own_marks = false;
  bool is_converted = false; ///< by the program Gwyddion
};

/// One channel of an instrument file as measured: not levelled, and missing
/// points not filled.
struct Scan {
  /// Rows and columns as in the file, the first row at y = 0; pixels need not
  /// be square. Every height is finite, or NaN at a missing point.
  HeightMap map;
  std::string channel; ///< title of the channel; may be empty
  std::string reader;  ///< which reader answered, e.g. "own reader of X3P"
  FileNumbers numbers = {};
};

/// What a case says about its map file.
struct ScanRequest {
  std::string format = "auto"; ///< the name of a MapFormat, or "auto"
  /// Title of the channel; empty: the only channel, or the first one that
  /// contains heights.
  std::optional<std::string> channel = {};
  MapScale scale = {};
  /// Number in the file at points without a height [FileNumbers::unit].
  std::optional<double> missing_value = {};
};

/// One channel of a file, for lists.
struct ChannelInfo {
  std::string title; ///< may be empty
  std::string unit;  ///< of the values as written in the file; may be empty
  int points_x = 0;
  int points_y = 0;
};

/// Number of missing points.
std::size_t count_missing(const Scan& scan);

/// Reads a channel of a file.
/// @throws input::InputError  the file is not a regular file, too large, of an
///                            unknown format or malformed (with its line or the
///                            part of the file), it has no such channel, all
///                            points are missing, a height is infinite, or a
///                            key of the case is missing or superfluous
Scan read_scan(const std::string& path, const ScanRequest& request);

/// Reads a channel from the bytes of a file in the same way.
/// @param name  of the file, for messages
Scan read_scan_bytes(std::string_view bytes, const std::string& name,
                     const ScanRequest& request);

/// Lists the channels of a file, also those that contain no heights.
/// @throws input::InputError  as read_scan
std::vector<ChannelInfo> list_channels(const std::string& path);

} // namespace asperity::surfaces
