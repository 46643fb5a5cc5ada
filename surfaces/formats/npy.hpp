#pragma once

// Reads and writes matrices in NumPy's .npy format, versions 1 to 3
// (numpy.lib.format), from any byte order and storage order.

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
