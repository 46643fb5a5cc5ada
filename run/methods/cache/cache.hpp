#pragma once

// An on-disk cache of earlier computations. Each entry is stored under the hash
// of all inputs that determine it. The class owns the cache folder: its
// entries, their integrity check and the size limit.

#include "base/file_bytes.hpp"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::methods {

/// The kinds of entries, used as file name extensions.
namespace entry_kind {
inline constexpr const char* step = "step";   ///< row, saved fields
inline constexpr const char* state = "state"; ///< restart state
inline constexpr const char* table = "table"; ///< table of a study
inline constexpr const char* face = "face";   ///< surface operator
} // namespace entry_kind

/// A size-limited store of byte strings. An entry is written to a temporary
/// file and then renamed. It carries its key, its kind and the hash of its
/// bytes: a damaged or renamed entry is removed when it is read and counts as
/// missing. Beyond the size limit the least recently used entries are removed
/// first. Any number of processes and threads may use the same folder.
///
/// Disk errors do not end a run: if the cache cannot be written, nothing is
/// cached and the run continues. contents() and clear() report them.
class Cache {
public:
  struct Contents {
    std::size_t entries = 0;
    std::uintmax_t bytes = 0;
  };

  /// Creates a disabled cache, which finds nothing and stores nothing.
  Cache() = default;

  /// @param folder      cache folder, created at the first write
  /// @param most_bytes  size limit of all entries together [B]; 0: no cache
  Cache(std::filesystem::path folder, std::uintmax_t most_bytes);

  Cache(const Cache&) = delete;
  Cache& operator=(const Cache&) = delete;

  bool is_on() const { return most_bytes_ > 0; }

  const std::filesystem::path& folder() const { return folder_; }

  std::uintmax_t most_bytes() const { return most_bytes_; }

  /// Returns the bytes of an entry, or nothing if it is missing or damaged.
  ///
  /// @param key   64 hexadecimal digits
  /// @param kind  one of entry_kind
  std::optional<std::string> read(const std::string& key,
                                  const std::string& kind);

  /// Opens an entry, whose bytes are checked by pieces. They remain readable if
  /// the cache removes it. Returns nothing if it is missing or damaged.
  std::optional<FileBytes> open(const std::string& key,
                                const std::string& kind);

  /// Returns true if the file of the entry exists. The file is not opened.
  bool has(const std::string& key, const std::string& kind) const;

  void write(const std::string& key, const std::string& kind,
             std::string_view bytes);

  /// The same for bytes that come in pieces.
  /// @param size    number of all bytes; if the cache has no room for them,
  ///                `pieces` is not called
  void write(const std::string& key, const std::string& kind,
             std::uintmax_t size, const BytePieces& pieces);

  void remove(const std::string& key, const std::string& kind);

  Contents contents() const;

  /// Returns one sentence for each kind of problem with entries so far; empty
  /// if there was none.
  std::vector<std::string> problems() const;

  /// Removes all entries and the partial files of killed processes.
  /// @throws std::runtime_error  some are left
  void clear();

private:
  std::filesystem::path path_of(const std::string& key,
                                const std::string& kind) const;
  void make_room();

  std::filesystem::path folder_;
  std::uintmax_t most_bytes_ = 0;
  std::mutex mutex_;
  std::optional<std::uintmax_t> bytes_; ///< total size as known to this process
  std::atomic<int> damaged_ = 0;
  std::atomic<int> refused_ = 0; ///< writes that the file system rejected
};

/// Returns the cache folder of the user: $ASPERITY_CACHE, otherwise
/// $XDG_CACHE_HOME/asperity, otherwise ~/.cache/asperity. The path is empty if
/// there is no home folder.
std::filesystem::path cache_folder();

/// Returns the size limit [B] from $ASPERITY_CACHE_SIZE, such as "500 MB" or a
/// number of bytes. The default is 2 GB.
///
/// @throws input::InputError  the value is not a size
std::uintmax_t cache_size();

} // namespace asperity::methods
