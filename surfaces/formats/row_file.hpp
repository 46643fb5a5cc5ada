#pragma once

// This file reads some rows of a map file without the others, from formats that
// permit it.

#include "surfaces/formats/scan.hpp"

#include <functional>
#include <optional>
#include <string>
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
};

/// Opens an .npy file whose numbers are stored row by row, a dataset of an HDF5
/// file, or a matrix of numbers as text.
/// @return  nothing if the file is of another kind, also if its numbers may be
///          a list x y z or if read_scan() would refuse the channel
/// @throws input::InputError  as read_scan(), if the header is malformed or a
///                            key of the case is missing or superfluous
std::optional<RowFile> row_file(const std::string& path,
                                const ScanRequest& request);

} // namespace asperity::surfaces
