#pragma once

// This file reads a result from an untrusted source in a child process first,
// because the packaged HDF5 library has memory errors that a damaged file can
// trigger.

#include <filesystem>
#include <functional>

namespace asperity::results {

/// Returns if read_result() of `path` terminates normally, with a result or
/// with an exception. No other thread of this process may be running.
/// @throws input::InputError  the child process was terminated by a signal, or
///                            it took more than ten minutes of CPU time
void require_readable(const std::filesystem::path& path);

/// The same for another way to read the file.
/// @param read  is called in the child process; its exceptions are ignored
void require_readable(const std::filesystem::path& path,
                      const std::function<void()>& read);

} // namespace asperity::results
