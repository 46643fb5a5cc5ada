#pragma once

// Reads input files as bytes: the case file, the files that it names, and those
// of other programs. Defines their size limits (docs/reference/case.md) and
// reports file errors as InputError.

#include <cstdint>
#include <filesystem>
#include <string>

namespace asperity::input {

inline constexpr std::uintmax_t mebibyte = std::uintmax_t{1024} * 1024;
/// Size limit for text that people write: cases, references and descriptions.
inline constexpr std::uintmax_t largest_text_file = mebibyte;
/// Size limit for files of numbers: height maps and spectra.
inline constexpr std::uintmax_t largest_number_file = 1024 * mebibyte;

/// Returns the complete content of a regular file.
///
/// @throws InputError  "path: what was found, what is allowed" (read_file.hpp)
std::string read_input_file(const std::filesystem::path& path,
                            std::uintmax_t largest);

/// Refuses a file of a folder that somebody else has made if a symbolic link
/// leads to it, or if it is outside the folder: it would be another file of
/// this machine. The folder itself may be a link.
/// @throws InputError  naming the link
void require_own_file(const std::filesystem::path& folder,
                      const std::filesystem::path& file);

} // namespace asperity::input
