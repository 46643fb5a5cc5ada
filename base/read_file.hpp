#pragma once

// Reads whole files into memory. It accepts only regular files up to a given
// size, so that no pipe or device can block the program or fill its memory.

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace asperity {

/// "path: what was found, what is allowed": the file does not exist, is not a
/// regular file, is larger than its limit, or cannot be read.
struct FileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Returns the whole content of a file, byte for byte. A symbolic link is
/// followed; a folder, pipe, device or socket is rejected without being read.
/// @param largest  largest size allowed [bytes]; no more than this is read even
///                 if the file grows meanwhile
/// @throws FileError  as described there
std::string read_file(const std::filesystem::path& path,
                      std::uintmax_t largest);

/// Makes the same checks for a file that a library opens by its name.
/// @throws FileError  as described there
void require_regular_file(const std::filesystem::path& path,
                          std::uintmax_t largest);

/// A size for messages, such as "64 MiB" or "1.5 GiB".
std::string bytes_text(double bytes);

} // namespace asperity
