#pragma once

// Folders for temporary files, which end with the object that made them.

#include <filesystem>
#include <string>

namespace asperity {

/// A new, empty folder among the temporary files of the system. The destructor
/// removes it with all of its contents.
class TemporaryFolder {
public:
  /// @param name  begins the name of the folder, for example "asperity-mesh"
  /// @throws std::system_error  the folder cannot be created
  explicit TemporaryFolder(const std::string& name);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

private:
  std::filesystem::path path_;
};

} // namespace asperity
