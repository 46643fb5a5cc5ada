#pragma once

// What a format of map files is, the list of all formats, and what their
// readers share. Everything that must know the formats asks the list: the
// recognition of files, the keys of a case and its messages, the page of the
// documents, the conversion of other formats, and the tests with any bytes.

#include "surfaces/formats/scan.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::surfaces {

/// The bytes of a map, in memory or in a file. Copies share what has been read.
class MapBytes {
public:
  /// Bytes in memory, which must outlive this object and its copies.
  /// @param name  of the file, for messages
  MapBytes(std::string_view bytes, std::string name)
      : name_(std::move(name)), all_(bytes) {}

  /// Bytes of a file, which are read when they are asked for.
  /// @throws input::InputError  the file is not a regular file that can be
  ///                            opened, or larger than
  ///                            input::largest_number_file
  static MapBytes of_file(const std::string& path);

  const std::string& name() const { return name_; }

  bool is_file() const { return is_file_; }

  /// The first 64 kB. They live as long as this object.
  std::string_view beginning() const;

  /// All bytes, which are then kept. They live as long as this object.
  /// @throws input::InputError  the file cannot be read
  std::string_view all() const;

private:
  std::string name_;
  bool is_file_ = false;
  std::string_view all_; ///< of bytes in memory
  std::string beginning_;
  mutable std::shared_ptr<const std::string> read_; ///< of a file
};

/// Which of the keys length, length_y, length_unit and height_unit the case
/// must give for files of a format.
enum class FileScales {
  none,    ///< the case must give length and height_unit
  some,    ///< it depends on the file, which its reader knows
  lengths, ///< the file has its lengths
  all      ///< the file has all of them
};

/// The row of a format in docs/reference/map-files.md, as Markdown.
struct FormatWords {
  std::string title; ///< of the format, also for messages: "Digital Surf"
  std::string recognised_by;
  std::string scales;
  std::string missing; ///< what is a missing point
  std::string channels;
};

/// Words of a header behind which a length of a side stands.
struct SideWords {
  std::string_view words;
  bool is_along_x;
};

/// A format of map files. Its functions throw input::InputError with the name
/// of the file and the line, byte or part that is malformed, and check every
/// size against the bytes that are there before they allocate memory.
struct MapFormat {
  /// [surface] format; "": it is only recognised, and has no name.
  const char* name;
  FormatWords words;
  /// Whether the bytes of a file, or the first 64 kB, are of this format.
  bool (*reads)(std::string_view bytes);
  /// Reads a channel. Heights are NaN at missing points; those that the number
  /// of the case or Scan::numbers.missing marks are found afterwards. Scales
  /// and channels of the case that no file of the format needs are refused
  /// before.
  Scan (*heights)(const MapBytes& bytes, const ScanRequest& request);
  /// Null: there is one channel, in metres.
  std::vector<ChannelInfo> (*channels)(const MapBytes& bytes) = nullptr;
  FileScales scales = FileScales::some;
  std::vector<std::string> endings = {}; ///< of file names: ".sur"
  /// Refuses a file that the program Gwyddion misreads. Null: there is none.
  void (*before_conversion)(const MapBytes& bytes) = nullptr;
  /// A map that Gwyddion has converted must have these sides.
  std::vector<SideWords> sides = {};
};

/// All formats. The first one that reads the bytes of a file is that of the
/// file; the last one, `convert`, reads any.
const std::vector<MapFormat>& map_formats();

/// Adds a format in front of all others, before any file is read or any case.
/// @return  true, so that a constant of a file can do it
bool add_map_format(MapFormat format);

/// The values of [surface] format: "auto" and the names of the formats.
std::vector<const char*> map_format_names();

/// The format of this name.
/// @throws std::domain_error  there is none
const MapFormat& map_format_called(std::string_view name);

/// The format of this name, or that of the bytes if it is "auto".
const MapFormat& format_of_map(const MapBytes& bytes, std::string_view name);

/// Whether bytes, or the beginning of a file, are a text of numbers without a
/// header of a known instrument.
bool is_text_map(std::string_view bytes);

/// " (Igor binary wave)" for the ending .ibw, "" for an unknown ending.
std::string name_in_brackets(const std::string& path);

/// The reader of .gwy files, to which other formats are converted.
Scan read_gwy(const MapBytes& bytes, const ScanRequest& request);
std::vector<ChannelInfo> gwy_channels(const MapBytes& bytes);

/// A map whose numbers the file has in its own unit.
/// @param values  of all points [numbers.unit], not finite at missing ones
Scan scan_of_numbers(const Grid& grid, std::vector<double> values,
                     const std::string& reader,
                     const FileNumbers& numbers = {});

/// @throws input::InputError  HDF5 and Gwyddion cannot read bytes in memory
void require_file(const MapBytes& bytes);

/// The scales of the case for a file without any: square pixels unless
/// scale.length_y is given.
/// @throws input::InputError  length or height_unit is missing
/// @param what  the file in words: "a plain matrix"
Grid grid_by_scale(const Grid& points, const std::string& name,
                   const std::string& what, const MapScale& scale);

/// Refuses a key [surface] of the case for what the file itself says.
/// @param why  "line 3 of map.txt gives '1 um'"
/// @throws input::InputError  the value is given
void refuse_given(const char* key, const std::optional<double>& value,
                  const std::string& why);

/// Refuses all keys of the scale for what the file itself says.
/// @throws input::InputError  a member of scale is given
void refuse_scale(const MapScale& scale, const std::string& name);

/// @throws input::InputError  the case asks for another channel than the only
///                            one of a file, which has the number 1
void refuse_channel(const ScanRequest& request, const std::string& channel,
                    const std::string& name);

/// Checks the points per side and the lengths of a file before memory is
/// allocated for them.
/// @param bytes_each  smallest size of a point in the file
/// @param bytes       bytes that are there
/// @throws input::InputError  fewer than two points per side, more points than
///                            the bytes can hold, lengths that are not positive
void require_sound_grid(const std::string& name, std::int64_t points_x,
                        std::int64_t points_y, double bytes_each,
                        std::uintmax_t bytes);
void require_sound_lengths(const std::string& name, const Grid& grid);

} // namespace asperity::surfaces
