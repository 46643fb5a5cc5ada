#pragma once

// This internal header of surfaces/formats says what a format of maps is,
// declares the readers of the individual formats, and what they share.

#include "surfaces/formats/map_bytes.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// A format of map files. Its functions throw input::InputError with the name
/// of the file and the line, byte or part that is malformed, and check every
/// size against the bytes that are there before they allocate memory.
struct MapReader {
  mechanics::MapFormat format;
  /// @param bytes  of the file, all or the first 64 kB
  bool (*recognises)(std::string_view bytes);
  OpenMap (*open)(const MapBytes& bytes, const ScanRequest& request);
  /// Empty: there is one channel, in metres.
  std::vector<ChannelInfo> (*channels)(const MapBytes& bytes) = nullptr;
};

/// The reader of a format, or that of the bytes if the format is automatic.
const MapReader& reader_of_map(const MapBytes& bytes,
                               mechanics::MapFormat format);

/// A matrix of numbers as text, with or without a header (map_file.hpp), a
/// list x y z, or Fourier coefficients.
OpenMap open_text(const MapBytes& bytes, const ScanRequest& request);
std::vector<ChannelInfo> text_channels(const MapBytes& bytes);

/// Fourier coefficients qX qY Re Im of a periodic square map, which has some
/// pair of complex conjugates for q and -q (docs/reference/map-files.md).
/// @return  nothing if the table is something else: there are other columns, an
///          index is no whole number or occurs twice, or no coefficient has a
///          conjugate or one is not that of its opposite
/// @throws input::InputError  a key of the case is missing or superfluous, or
///                            there are too many waves
std::optional<OpenMap> fourier_map(const NumberTable& table,
                                   const MapScale& scale);
/// Number of points along a side of such a map; 0: it is none.
int fourier_points(const NumberTable& table);

/// ISO 25178-71 with the header aISO-1.0, bISO-1.0, aBCR-1.0 or bBCR-1.0; only
/// a binary one is read by rows.
OpenMap open_sdf(const MapBytes& bytes, const ScanRequest& request);

/// ISO 5436-2: a zip archive with main.xml.
OpenMap open_x3p(const MapBytes& bytes, const ScanRequest& request);

/// NumPy's .npy; the scales are those of the case. It is read by rows unless it
/// is a list x y z.
OpenMap open_npy(const MapBytes& bytes, const ScanRequest& request);
std::vector<ChannelInfo> npy_channels(const MapBytes& bytes);

/// A dataset of an HDF5 file, read as that of an .npy file.
OpenMap open_hdf5(const MapBytes& bytes, const ScanRequest& request);
std::vector<ChannelInfo> hdf5_channels(const MapBytes& bytes);

/// Gwyddion's native format.
OpenMap open_gwy(const MapBytes& bytes, const ScanRequest& request);
std::vector<ChannelInfo> gwy_channels(const MapBytes& bytes);

/// Digital Surf .sur: one uncompressed surface, read by rows.
OpenMap open_sur(const MapBytes& bytes, const ScanRequest& request);

/// WSxM .top, .stp and others: a header of lines, then numbers, whose least and
/// largest give their unit. It is read by rows.
OpenMap open_wsxm(const MapBytes& bytes, const ScanRequest& request);

/// Any other format through the program Gwyddion.
OpenMap open_converted(const MapBytes& bytes, const ScanRequest& request);
std::vector<ChannelInfo> converted_channels(const MapBytes& bytes);

/// A map of a format that is not read by rows.
/// @param values  of all points [numbers.unit], not finite at missing ones
OpenMap map_in_memory(const Grid& grid, std::vector<double> values,
                      const std::string& reader,
                      const FileNumbers& numbers = {});

/// All rows of a map.
/// @throws input::InputError  all points are missing
Scan scan_of_map(const OpenMap& map, const std::string& name);

/// @throws input::InputError  HDF5 and Gwyddion cannot read bytes in memory
void require_file(const MapBytes& bytes);

/// The scales of the case for a file without any: square pixels unless
/// scale.length_y is given.
/// @throws input::InputError  length or height_unit is missing
/// @param what  the file in words: "a plain matrix"
Grid grid_by_scale(const Grid& points, const std::string& name,
                   const std::string& what, const MapScale& scale);

/// Refuses keys of the case for what the file itself says.
/// @throws input::InputError  a member of scale is given
void refuse_scale(const MapScale& scale, const std::string& name);

/// @throws input::InputError  the case asks for another channel than the only
///                            one of a file, which has the number 1
void refuse_channel(const ScanRequest& request, const std::string& channel,
                    const std::string& name);

/// Makes those points missing that have the number of the case or the one that
/// the header of the file names, to six digits, because files round it.
/// @param heights  [m], set to NaN
void mark_missing_value(std::span<double> heights, const FileNumbers& numbers,
                        const std::optional<double>& missing_value);

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
