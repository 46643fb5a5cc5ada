#pragma once

// What earlier runs computed, kept on disk under the hash of everything that
// decides it. Owns the folder: its entries, their check, their bound.

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::app {

/// The kinds of entries, which are the ends of their files' names.
namespace entry_kind {
inline constexpr const char* step = "step";   ///< row and kept maps
inline constexpr const char* state = "state"; ///< to go on from a step
inline constexpr const char* table = "table"; ///< of a study
inline constexpr const char* face = "face";   ///< operator of a block's face
} // namespace entry_kind

/// A bounded store of byte strings. An entry is written beside its place and
/// renamed into it, and carries its key, its kind and the hash of its bytes:
/// one that was damaged or renamed is removed when it is read and counts as
/// missing. Beyond the bound the entries
/// that were not used for the longest time go first. Any number of processes
/// and threads may use one folder.
///
/// Nothing here throws for what a disk refuses: a cache that cannot be written
/// keeps nothing, and the run goes on.
class Cache {
public:
  struct Contents {
    std::size_t entries = 0;
    std::uintmax_t bytes = 0;
  };

  /// Finds nothing and keeps nothing.
  Cache() = default;

  /// @param folder      made at the first write
  /// @param most_bytes  bound of all entries together; 0: no cache
  Cache(std::filesystem::path folder, std::uintmax_t most_bytes);

  Cache(const Cache&) = delete;
  Cache& operator=(const Cache&) = delete;

  bool is_on() const { return most_bytes_ > 0; }

  const std::filesystem::path& folder() const { return folder_; }

  std::uintmax_t most_bytes() const { return most_bytes_; }

  /// @param key   64 hexadecimal digits
  /// @param kind  one of entry_kind
  std::optional<std::string> read(const std::string& key,
                                  const std::string& kind);

  /// True if there is such a file; it is not opened.
  bool has(const std::string& key, const std::string& kind) const;

  void write(const std::string& key, const std::string& kind,
             std::string_view bytes);

  void remove(const std::string& key, const std::string& kind);

  Contents contents() const;

  /// What went wrong with entries so far, in a sentence each; empty if nothing
  /// did.
  std::vector<std::string> problems() const;

  /// Removes every entry, and what killed writers left.
  void clear();

private:
  std::filesystem::path path_of(const std::string& key,
                                const std::string& kind) const;
  void make_room();

  std::filesystem::path folder_;
  std::uintmax_t most_bytes_ = 0;
  std::mutex mutex_;
  std::optional<std::uintmax_t> bytes_; ///< as far as this process knows
  std::atomic<int> damaged_ = 0;
  std::atomic<int> refused_ = 0; ///< writes by the disk
};

/// Where the cache of this user is: $ASPERITY_CACHE, else
/// $XDG_CACHE_HOME/asperity, else ~/.cache/asperity; empty without a home.
std::filesystem::path cache_folder();

/// $ASPERITY_CACHE_SIZE, "500 MB", "2 GB" or bytes; 2 GB if it is not set.
/// @throws cases::CaseError  it is no size
std::uintmax_t cache_size();

} // namespace asperity::app
