#pragma once

// This internal header of surfaces/formats keeps what a pass over a whole file
// has found, because several steps of a run ask for the rows of one map.

#include "input/input_error.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace asperity::surfaces {

/// Size and time of a file, by which a change of it is noticed.
struct FileStamp {
  explicit FileStamp(const std::string& path)
      : bytes(std::filesystem::file_size(path)),
        time(std::filesystem::last_write_time(path)) {}

  bool operator==(const FileStamp&) const = default;

  /// @throws input::InputError  the file has another size or time now
  void require_unchanged(const std::string& path) const {
    if (*this != FileStamp(path))
      refuse_changed(path);
  }

  [[noreturn]] static void refuse_changed(const std::string& path) {
    throw input::InputError(path + ": has changed since the run began");
  }

  std::uintmax_t bytes;
  std::filesystem::file_time_type time;
};

/// Returns make(), or what it returned last if the file and the key are the
/// same and the file has not changed.
/// @param key  what else make() depends on
template <class Found, class Key, class Make>
std::shared_ptr<const Found> known_of_file(const std::string& path,
                                           const Key& key, const Make& make) {
  struct Known {
    std::string path;
    Key key;
    FileStamp stamp;
    std::shared_ptr<const Found> found;
  };

  static std::mutex mutex;
  static std::unique_ptr<Known> known;
  const std::lock_guard lock(mutex);
  const FileStamp stamp(path);
  if (known == nullptr || known->path != path || known->key != key ||
      known->stamp != stamp) {
    known.reset(); // its memory is free while the next is found
    known = std::make_unique<Known>(
        Known{path, key, stamp, std::make_shared<const Found>(make())});
  }
  return known->found;
}

} // namespace asperity::surfaces
