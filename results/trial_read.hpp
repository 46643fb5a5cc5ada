#pragma once

// Reads a result from an untrusted source in a child process first, because the
// packaged HDF5 library has memory errors that a damaged file can trigger.

#include <filesystem>
#include <functional>

namespace asperity::results {

/// Returns the CPU time that the reading of a result may take [s]: in
/// proportion to the size of its file, within limits, and a hundred times what
/// a good file takes. The library can loop for ever on a damaged one.
/// @param path  the file, or the folder that contains result.h5
double read_time_limit(const std::filesystem::path& path);

/// Returns if read_result() of `path` terminates normally, with a result or
/// with an exception. No other thread of this process may be running.
/// @throws input::InputError  the child process was terminated by a signal, or
///                            it exceeded read_time_limit()
void require_readable(const std::filesystem::path& path);

/// The same for another way to read the file.
/// @param read  is called in the child process; its exceptions are ignored
void require_readable(const std::filesystem::path& path,
                      const std::function<void()>& read);

} // namespace asperity::results
