#pragma once

// Reads a result from other people for a first time in a child process: the
// packaged HDF5 library has errors of memory that a damaged file can reach.

#include <filesystem>

namespace asperity::results {

/// Returns if read_result() of `path` comes to an end, with a result or with an
/// error of its own. No other thread of this process may be at work.
/// @throws cases::CaseError  it does not: a signal ended the child, or it took
///         more than ten minutes of processor time
void require_readable(const std::filesystem::path& path);

} // namespace asperity::results
