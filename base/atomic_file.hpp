#pragma once

// Writes files atomically: a temporary file in the same folder is written and
// renamed, so that the file exists either completely or not at all. Every
// output file that a reader may open is written this way.

#include <filesystem>
#include <string_view>

namespace asperity {

/// A hidden file name in the folder of `path` that is unique in this and all
/// other processes: ".<file name>.<process>-<count>.part".
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Writes `text` to `path`. A reader sees either the old file or the new one,
/// never a part, even if the process is killed; the bytes are on disk before
/// the rename. The folder must exist; permissions follow the umask. A link
/// stays: the file that it names is replaced. What is no file, such as a pipe
/// or /dev/null, is written to as it is.
/// @throws std::system_error naming the path; the old file is then unchanged
///         and no temporary file is left
void write_file_atomically(const std::filesystem::path& path,
                           std::string_view text);

} // namespace asperity
