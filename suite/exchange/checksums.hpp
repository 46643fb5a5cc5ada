#pragma once

// SHA256SUMS, by which a problem folder states which files it has and what is
// in them.

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace asperity::exchange {

inline constexpr const char* checksum_file = "SHA256SUMS";

/// Files with their SHA-256, in the order of writing.
using Hashes = std::vector<std::pair<std::string, std::string>>;

/// The text of SHA256SUMS, as `sha256sum -c` reads it.
std::string checksum_text(const Hashes& hashes);

/// Verifies every file of SHA256SUMS.
/// @return  the names of these files; empty if the folder has no SHA256SUMS
/// @throws input::InputError  naming the file: a line is no checksum, or a file
///                            is missing, outside the folder, behind a symbolic
///                            link, or has another checksum
std::vector<std::string> verified_files(const std::filesystem::path& folder);

} // namespace asperity::exchange
