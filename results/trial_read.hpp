#pragma once

// This file reads a result from an untrusted source in a child process first,
// because the packaged HDF5 library has memory errors that a damaged file can
// trigger.

#include <filesystem>

namespace asperity::results {

/// Returns if read_result() of `path` terminates normally, with a result or
/// with an exception. No other thread of this process may be running.
/// @throws cases::CaseError  the child process was terminated by a signal, or
///                           it took more than ten minutes of CPU time
void require_readable(const std::filesystem::path& path);

} // namespace asperity::results
