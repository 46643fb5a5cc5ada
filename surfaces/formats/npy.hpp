#pragma once

// Reads and writes matrices in NumPy's .npy format, versions 1 to 3
// (numpy.lib.format), from any byte order and storage order.

#include "surfaces/formats/map_bytes.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// Numbers in rows and columns, row by row.
struct Matrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> numbers; ///< rows * columns values
};

/// What the header of an .npy file says about its numbers.
struct NpyLayout {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::size_t begin = 0;     ///< place of the first number in the file [bytes]
  std::size_t width = 8;     ///< of a number [bytes], 4 or 8
  bool is_swapped = false;   ///< bytes are in the other order
  bool is_by_column = false; ///< Fortran order
};

/// Reads the header.
/// @throws input::InputError  as read_npy_text
NpyLayout npy_layout(const MapBytes& bytes);

/// Reads whole rows, by pieces of some MB [1].
/// @throws input::InputError  the file has become shorter
std::vector<double> npy_rows(const MapBytes& bytes, const NpyLayout& layout,
                             int first, int count);

/// Reads a two-dimensional array of 4- or 8-byte floating-point numbers. They
/// need not be finite.
/// @param name  of the file, for messages
/// @throws input::InputError  "name: what was found, what is allowed": not an
///                            .npy file, another type of number or number of
///                            dimensions, or fewer or more bytes than numbers
Matrix read_npy_text(std::string_view bytes, const std::string& name);

/// Reads a whole file in the same way.
/// @throws input::InputError  as above, or the file cannot be read
Matrix read_npy(const std::filesystem::path& path);

/// Returns a file of version 1 with little-endian float64 in C order.
/// @param numbers  rows * columns values, row by row
/// @throws std::domain_error  another number of values
std::string npy_bytes(std::span<const double> numbers, std::size_t rows,
                      std::size_t columns);

} // namespace asperity::surfaces
