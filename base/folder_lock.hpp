#pragma once

// One writer per folder: who holds it, and the refusal of everybody else.

#include "base/file_descriptor.hpp"

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace asperity {

/// "out/polymer is in use by run polymer (process 123 on host, since ...)".
struct FolderInUse : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Holds a folder for as long as it lives, by flock on the file ".lock" in it.
/// The kernel releases the lock when the process ends, however it ends, so a
/// file that a killed process left locks nothing. At the end the file goes, and
/// so do folders that the lock had made and that are still empty.
class FolderLock {
public:
  /// Makes the folder if need be; waits half a second for a holder to end.
  /// @param purpose  what the folder is held for, "run polymer"
  /// @throws FolderInUse        naming who holds it
  /// @throws std::system_error  the folder cannot be made or written to, or its
  ///                            file system has no locks
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
