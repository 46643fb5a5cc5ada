#pragma once

// Exclusive write access to a folder, with an error message that names the
// holder.

#include "base/file_descriptor.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity {

/// The folder is locked: "out/polymer is in use by run polymer (process 123 on
/// host, since ...)"; or its path names a file.
struct UnusableFolder : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Locks a folder for the lifetime of the object, by flock on the file ".lock"
/// in it. The kernel releases the lock when the process ends, however it ends,
/// so the file that a killed process leaves locks nothing. The destructor
/// removes the file and those folders that the constructor created and that are
/// still empty.
class FolderLock {
public:
  /// Creates the folder if necessary and waits half a second for a holder to
  /// end.
  /// @param purpose  what the folder is locked for, such as "run polymer"
  /// @throws UnusableFolder     naming the holder, or the file in its place
  /// @throws std::system_error  the folder cannot be created or written to, or
  ///                            its file system does not support locks
  FolderLock(const std::filesystem::path& folder, const std::string& purpose);
  ~FolderLock();
  FolderLock(FolderLock&&) = default;
  FolderLock& operator=(FolderLock&&) = delete;

private:
  std::filesystem::path path_;
  std::vector<std::filesystem::path> made_; ///< the deepest first
  FileDescriptor file_;
};

} // namespace asperity
