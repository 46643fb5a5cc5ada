#pragma once

// Reads a file from an untrusted source in a child process first, because the
// packaged HDF5 library has memory errors that a damaged file can trigger.

#include "input/input_error.hpp"
#include "results/storage/hdf5_file.hpp"

#include <filesystem>
#include <functional>
#include <mutex>

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

/// Returns read(file) of an HDF5 file of any content, after a trial.
/// @throws input::InputError  as require_readable(), or read() finds the file
///                            malformed
template <class Read>
auto read_any_hdf5(const std::filesystem::path& path, const Read& read) {
  const auto read_file = [&] {
    const std::lock_guard lock(hdf5_mutex());
    return read(Hdf5File(path, Hdf5File::Mode::read));
  };
  require_readable(path, [&] { (void)read_file(); });
  try {
    return read_file();
  } catch (const Hdf5Error& error) {
    throw input::InputError(error.what());
  }
}

} // namespace asperity::results
