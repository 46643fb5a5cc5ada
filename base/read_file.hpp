#pragma once

// Whole files into memory. Owns what may be opened at all: regular files of a
// stated size, so that no pipe or device can hold the program or fill it.

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace asperity {

/// "path: what was found, what is allowed": there is no such file, it is no
/// regular file, it is larger than its limit, or the system cannot read it.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The whole content of a file, byte for byte. A symbolic link is followed; a
/// folder, pipe, device or socket is refused without being read.
/// @param largest  size allowed [bytes], which is also all that is read of a
///                 file that grows meanwhile
/// @throws FileError
std::string read_file(const std::filesystem::path& path,
                      std::uintmax_t largest);

/// The same checks for a file that a library opens by its name.
/// @throws FileError
void require_regular_file(const std::filesystem::path& path,
                          std::uintmax_t largest);

/// "64 MiB", "1.5 GiB", in messages about sizes and memory.
std::string bytes_text(double bytes);

} // namespace asperity
