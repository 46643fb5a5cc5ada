#pragma once

// This internal header of surfaces/formats declares the readers of the
// individual formats, which scan.cpp chooses from, and what they share.

#include "surfaces/formats/row_file.hpp"
#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// What a reader finds in a file: its channels, and one of them if asked.
struct FileContent {
  std::vector<ChannelInfo> channels;
  Scan scan; ///< the chosen channel
};

/// How a request is answered: one channel, or only the list.
enum class Asked { scan, channels };

/// The readers. Each throws input::InputError with the name of the file and the
/// line, byte or part that is malformed, and checks every size against the
/// bytes that are there before it allocates memory.

/// A matrix of numbers as text, with or without a header (map_file.hpp), or a
/// list x y z.
Scan read_text_scan(std::string_view bytes, const std::string& name,
                    const ScanRequest& request);

/// The same, read by rows; nothing if the file is no text after all, or if
/// read_scan() would refuse the channel. The whole text is read once for the
/// places of its lines, and lists whose points are in another order than that
/// of their rows three times.
std::optional<RowFile> text_row_file(const std::string& path,
                                     const ScanRequest& request);

/// Fourier coefficients qX qY Re Im of a periodic square map, which has some
/// pair of complex conjugates for q and -q (docs/reference/map-files.md).
/// @return  nothing if the table is something else: there are other columns, an
///          index is no whole number or occurs twice, or no coefficient has a
///          conjugate or one is not that of its opposite
/// @throws input::InputError  a key of the case is missing or superfluous, or
///                            there are too many waves
std::optional<Scan> fourier_scan(const NumberTable& table,
                                 const MapScale& scale);
inline constexpr std::size_t fourier_columns = 4;
/// Number of points along a side of such a map; 0: it is none.
int fourier_points(const NumberTable& table);

/// What a text matrix says of its map.
struct TextMatrix {
  Grid grid;
  double height_unit = 1.0; ///< [m] per unit of the numbers
  std::string channel;      ///< may be empty
  std::string reader;
  std::optional<double> missing_value = {}; ///< number that the header names
};

/// @param table    which is no list; its numbers are not read
/// @throws input::InputError  as read_text_scan()
TextMatrix text_matrix(const NumberTable& table, const ScanRequest& request);
/// The only channel of such a file.
ChannelInfo text_channel(std::string_view bytes, const std::string& name);
/// ISO 25178-71 with the header aISO-1.0, bISO-1.0, aBCR-1.0 or bBCR-1.0.
Scan read_sdf_scan(std::string_view bytes, const std::string& name);
/// The same file, read by rows.
/// @param beginning  of the file, at least the header if it is binary
std::optional<RowFile> sdf_row_file(const std::string& path,
                                    std::string_view beginning,
                                    const ScanRequest& request);
/// ISO 5436-2: a zip archive with main.xml.
Scan read_x3p_scan(std::string_view bytes, const std::string& name);
/// The same file, read by rows, which are unpacked once more for each call
/// unless they are asked for in their order.
/// @return  nothing if the points are in main.xml itself, which is in memory as
///          a whole, or if read_scan() would refuse the channel
std::optional<RowFile> x3p_row_file(const std::string& path,
                                    const ScanRequest& request);
/// NumPy's .npy; the scales are those of the case.
Scan read_npy_scan(std::string_view bytes, const std::string& name,
                   const ScanRequest& request);
/// The same, read by rows.
/// @param numbers  points per side and rows of the file, with the unit 1
RowFile npy_row_file(const std::string& path, RowFile numbers,
                     const ScanRequest& request);
ChannelInfo npy_channel(std::string_view bytes, const std::string& name);
/// Gwyddion's native format.
FileContent read_gwy_file(std::string_view bytes, const std::string& name,
                          const ScanRequest& request, Asked asked);
/// The same channel, read by rows.
std::optional<RowFile> gwy_row_file(const std::string& path,
                                    const ScanRequest& request);
/// A dataset of an HDF5 file.
FileContent read_hdf5_file(const std::string& path, const ScanRequest& request,
                           Asked asked);
/// The same dataset, read by rows.
std::optional<RowFile> hdf5_row_file(const std::string& path,
                                     const ScanRequest& request);
/// Digital Surf .sur: one uncompressed surface.
/// @param beginning  of the file, at least its header
RowFile sur_row_file(const std::string& path, std::string_view beginning,
                     const ScanRequest& request);
/// WSxM .top, .stp and others: a header of lines, then numbers. The whole file
/// is read once for its least and largest number.
/// @param beginning  of the file, at least its header
RowFile wsxm_row_file(const std::string& path, std::string_view beginning,
                      const ScanRequest& request);
/// Any other format through the program Gwyddion.
FileContent read_converted_file(const std::string& path,
                                const ScanRequest& request, Asked asked);

/// Whether the case names another channel than the only one of a file, which
/// has the number 1.
bool names_another(const std::optional<std::string>& wanted,
                   const std::string& title);

/// The scales of the case for a file without any: square pixels unless
/// scale.length_y is given.
/// @throws input::InputError  length or height_unit is missing
/// @param what  the file in words: "a plain matrix"
Grid grid_by_scale(const Grid& points, const std::string& name,
                   const std::string& what, const MapScale& scale);

/// The map of such a file.
/// @throws input::InputError  as grid_by_scale, or all points are missing
Scan scan_by_scale(const Grid& points, std::vector<double> numbers,
                   const std::string& name, const std::string& what,
                   const MapScale& scale);

/// Refuses keys of the case for what the file itself says.
/// @throws input::InputError  a member of scale is given
void refuse_scale(const MapScale& scale, const std::string& name);

/// @throws input::InputError  the case asks for another channel than the only
///                            one of a file
void refuse_channel(const ScanRequest& request, const std::string& channel,
                    const std::string& name);

/// Makes those points missing that have the number of the case or the one that
/// the header of the file names, to six digits, because files round it.
/// @param heights  [m], set to NaN
void mark_missing_value(std::span<double> heights, const FileNumbers& numbers,
                        const std::optional<double>& missing_value);

/// Marks every height that is not finite as missing and sets it to 0.
/// @throws input::InputError  all points are missing
void mark_missing(Scan& scan, const std::string& name);

/// Multiplies all heights.
void multiply_heights(Scan& scan, double factor);

/// Checks the points per side and the lengths of a file before memory is
/// allocated for them.
/// @param bytes_each  smallest size of a point in the file
/// @param bytes       bytes that are there
/// @throws input::InputError  fewer than two points per side, more points than
///                            the bytes can hold, lengths that are not positive
void require_sound_grid(const std::string& name, std::int64_t points_x,
                        std::int64_t points_y, double bytes_each,
                        std::size_t bytes);
/// Whether the points per side are those of a map.
bool are_sizes_sound(std::int64_t points_x, std::int64_t points_y);
void require_sound_lengths(const std::string& name, const Grid& grid);

} // namespace asperity::surfaces
