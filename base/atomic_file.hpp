#pragma once

// Files that are there whole or not at all: written beside their place and
// renamed over it. Every output a reader may open goes this way.

#include <filesystem>
#include <string_view>

namespace asperity {

/// A hidden name in the folder of `path` that nobody else in this or another
/// process gets: ".<file name>.<process>-<count>.part".
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Puts `text` at `path`. A reader sees the old file or the new one, never a
/// part, also when the process is killed at any moment; the bytes are on disk
/// before the rename. The folder must exist; permissions follow the umask.
/// @throws std::system_error naming the path; the old file is then untouched
///         and no temporary is left
void write_file_atomically(const std::filesystem::path& path,
                           std::string_view text);

} // namespace asperity
