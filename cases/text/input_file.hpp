#pragma once

// The files that a case consists of or names, as bytes. Owns their largest
// sizes (docs/case.md) and turns what is wrong with a file into a CaseError.

#include <cstdint>
#include <filesystem>
#include <string>

namespace asperity::cases {

inline constexpr std::uintmax_t mebibyte = 1024 * 1024;
inline constexpr std::uintmax_t largest_case_file = mebibyte;
inline constexpr std::uintmax_t largest_reference_file = mebibyte;
/// Of numbers: height maps, spectra.
inline constexpr std::uintmax_t largest_number_file = 1024 * mebibyte;

/// The whole content of a regular file.
/// @throws CaseError  "path: what was found, what is allowed" (read_file.hpp)
std::string read_input_file(const std::filesystem::path& path,
                            std::uintmax_t largest);

} // namespace asperity::cases
