#pragma once

// Reads the case file and the files that it names as bytes. Defines their size
// limits (docs/reference/case.md) and reports file errors as CaseError.

#include <cstdint>
#include <filesystem>
#include <string>

namespace asperity::cases {

inline constexpr std::uintmax_t mebibyte = std::uintmax_t{1024} * 1024;
inline constexpr std::uintmax_t largest_case_file = mebibyte;
inline constexpr std::uintmax_t largest_reference_file = mebibyte;
/// Size limit for files of numbers: height maps and spectra.
inline constexpr std::uintmax_t largest_number_file = 1024 * mebibyte;

/// Returns the complete content of a regular file.
///
/// @throws CaseError  "path: what was found, what is allowed" (read_file.hpp)
std::string read_input_file(const std::filesystem::path& path,
                            std::uintmax_t largest);

} // namespace asperity::cases
