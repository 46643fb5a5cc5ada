#pragma once

// Reads some rows of a map file without the others, from formats that permit
// it.

#include "surfaces/formats/scan.hpp"
#include "surfaces/maps/corrections.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// A map file whose rows can be read separately.
struct RowFile {
  Grid grid;           ///< of the whole file
  std::string channel; ///< title; may be empty
  std::string reader;  ///< as Scan::reader
  /// Returns whole rows in the order of the file [m], not finite at missing
  /// points; the heights have the bits of read_scan().
  std::function<std::vector<double>(int first, int count)> rows;
  /// Points without a height in the whole file, if it was read to its end.
  std::optional<std::size_t> missing = {};
  /// Counts the points without a height in a part of the map, if that takes
  /// less time than reading its rows by pieces; else empty.
  std::function<std::size_t(const PixelWindow&)> missing_in = {};
  FileNumbers numbers = {};
};

/// Numbers of a map that a file stores one after the other, row by row.
struct StoredNumbers {
  std::string path;
  std::uint64_t begin = 0;  ///< first byte
  std::size_t width = 8;    ///< of a number [bytes]
  std::size_t columns = 0;  ///< numbers of a row
  double height_unit = 1.0; ///< [m] per unit of the numbers
  /// Converts numbers.size() * width bytes.
  std::function<void(std::string_view bytes, std::span<double> numbers)>
      convert;
};

/// Reads whole rows, by pieces of some MB [m].
/// @throws input::InputError  the file has become shorter
std::vector<double> stored_rows(const StoredNumbers& numbers, int first,
                                int count);

/// Opens an .npy file, a dataset of an HDF5 file, an SDF file, an X3P file
/// whose points are not in main.xml, a .gwy, Digital Surf or WSxM file, a
/// matrix of numbers as text, or a list x y z.
/// @return  nothing if the file is of another kind, or if read_scan() would
///          refuse the channel
/// @throws input::InputError  as read_scan(), if the header is malformed or a
///                            key of the case is missing or superfluous
std::optional<RowFile> row_file(const std::string& path,
                                const ScanRequest& request);

} // namespace asperity::surfaces
