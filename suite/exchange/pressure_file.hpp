#pragma once

// Reads a field that another program has written: .npy, HDF5 or text.

#include "surfaces/formats/npy.hpp"

#include <cstddef>
#include <filesystem>

namespace asperity::exchange {

/// Reads a matrix from a file; its ending decides how: .npy; .h5 or .hdf5, from
/// the dataset "pressure" or the only one; .csv, .txt or .dat, numbers
/// separated by commas, semicolons, blanks or tabs.
/// @param most  numbers that it may have; those of an HDF5 file are counted
///              before any is read, because they may be packed
/// @throws input::InputError  another ending, a file that cannot be read, more
///                            numbers, or some that are not finite
surfaces::Matrix read_pressure_file(const std::filesystem::path& path,
                                    std::size_t most);

} // namespace asperity::exchange
