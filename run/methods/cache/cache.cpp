#include "run/methods/cache/cache.hpp"

#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "input/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace asperity::methods {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t hash_length = 64;
constexpr std::uintmax_t default_size = 2'000'000'000;

/// Fraction of the size limit to which the cache is pruned. It is below one so
/// that the folder is not scanned again at the very next write.
constexpr double fill_after_pruning = 0.9;

/// Age beyond which a partial file is known to be left over from a killed
/// process, because no write takes that long.
constexpr std::chrono::hours oldest_part{1};

struct Entry {
  fs::path path;
  fs::file_time_type used;
  std::uintmax_t bytes = 0;
};

bool is_entry(const fs::path& path) {
  const std::string name = path.stem().string();
  return name.size() == hash_length &&
         name.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool is_left_over(const fs::directory_entry& file) {
  std::error_code error;
  return file.path().extension() == ".part" &&
         file.last_write_time(error) + oldest_part <
             fs::file_time_type::clock::now();
}

/// Calls `visit` for each file. Other processes may remove files meanwhile.
template <class Visit>
void for_each_file(const fs::path& folder, Visit visit) {
  std::error_code error;
  for (fs::directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error))
    visit(*file);
}

std::vector<Entry> entries_of(const fs::path& folder) {
  std::vector<Entry> entries;
  for_each_file(folder, [&](const fs::directory_entry& file) {
    std::error_code error;
    Entry entry{file.path(), file.last_write_time(error), 0};
    if (!error)
      entry.bytes = file.file_size(error);
    if (!error && is_entry(entry.path))
      entries.push_back(std::move(entry));
  });
  return entries;
}

std::uintmax_t total_bytes_of(const std::vector<Entry>& entries) {
  std::uintmax_t bytes = 0;
  for (const Entry& entry : entries)
    bytes += entry.bytes;
  return bytes;
}

/// The header of an entry. It holds the key and the kind, so that a renamed
/// entry is detected.
/// @param hash  of the bytes behind the header
std::string head_of(const std::string& key, const std::string& kind,
                    const std::string& hash) {
  return fmt::format("asperity-cache-3\n{} {}\n{}\n", key, kind, hash);
}

std::size_t head_size(const std::string& key, const std::string& kind) {
  return head_of(key, kind, content_hash("")).size();
}

/// Opens the bytes after the header if the header matches this entry and the
/// hash of the bytes.
std::optional<FileBytes> checked_entry(const fs::path& path,
                                       const std::string& key,
                                       const std::string& kind) {
  const std::optional<FileBytes> file = FileBytes::of(path);
  std::string head(head_size(key, kind), '\0');
  if (!file || file->read_some(0, head) < head.size())
    return std::nullopt;
  FileBytes bytes = file->part(head.size(), file->size() - head.size());
  return head == head_of(key, kind, bytes.hash()) ? std::optional(bytes)
                                                  : std::nullopt;
}

} // namespace

Cache::Cache(fs::path folder, std::uintmax_t most_bytes)
    : folder_(std::move(folder)),
      most_bytes_(folder_.empty() ? 0 : most_bytes) {}

fs::path Cache::path_of(const std::string& key, const std::string& kind) const {
  return folder_ / (key + "." + kind);
}

bool Cache::has(const std::string& key, const std::string& kind) const {
  std::error_code error;
  return is_on() && fs::exists(path_of(key, kind), error);
}

std::optional<std::string> Cache::read(const std::string& key,
                                       const std::string& kind) {
  const std::optional<FileBytes> entry = open(key, kind);
  if (!entry)
    return std::nullopt;
  std::string bytes(entry->size(), '\0');
  entry->read(0, bytes);
  return bytes;
}

std::optional<FileBytes> Cache::open(const std::string& key,
                                     const std::string& kind) {
  if (!has(key, kind))
    return std::nullopt;
  std::optional<FileBytes> entry = checked_entry(path_of(key, kind), key, kind);
  std::error_code error;
  if (entry) {
    fs::last_write_time(path_of(key, kind), fs::file_time_type::clock::now(),
                        error);
  } else if (has(key, kind)) { // not removed by another process meanwhile
    ++damaged_;
    remove(key, kind);
  }
  return entry;
}

void Cache::write(const std::string& key, const std::string& kind,
                  std::string_view bytes) {
  write(key, kind, bytes.size(),
        [bytes](const TakeBytes& take) { take(bytes); });
}

void Cache::write(const std::string& key, const std::string& kind,
                  std::uintmax_t size, const BytePieces& pieces) {
  size += head_size(key, kind);
  if (size > most_bytes_)
    return;
  std::error_code error;
  fs::create_directories(folder_, error);
  const fs::path path = path_of(key, kind);
  const fs::path part = temporary_beside(path);
  // The file is not synced to disk: an entry that a power failure truncates
  // does not pass the check.
  std::ofstream stream(part, std::ios::binary);
  ContentHash hash;
  stream << head_of(key, kind, hash.text());
  try {
    pieces([&](std::string_view bytes) {
      hash.add(bytes);
      stream << bytes;
    });
  } catch (...) {
    fs::remove(part, error);
    throw;
  }
  stream.seekp(0) << head_of(key, kind, hash.text());
  stream.close();
  if (stream)
    fs::rename(part, path, error);
  if (!stream || error) {
    ++refused_;
    fs::remove(part, error);
    return;
  }
  const std::lock_guard lock(mutex_);
  bytes_ = bytes_ ? *bytes_ + size : total_bytes_of(entries_of(folder_));
  if (*bytes_ > most_bytes_)
    make_room();
}

void Cache::make_room() {
  std::vector<Entry> entries = entries_of(folder_);
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.used < b.used; });
  bytes_ = total_bytes_of(entries);
  if (*bytes_ <= most_bytes_)
    return;
  const auto enough = static_cast<std::uintmax_t>(
      fill_after_pruning * static_cast<double>(most_bytes_));
  for (const Entry& entry : entries) {
    if (*bytes_ <= enough)
      break;
    std::error_code error;
    fs::remove(entry.path, error);
    *bytes_ -= entry.bytes;
  }
  for_each_file(folder_, [](const fs::directory_entry& file) {
    std::error_code error;
    if (is_left_over(file))
      fs::remove(file.path(), error);
  });
}

void Cache::remove(const std::string& key, const std::string& kind) {
  if (!is_on())
    return;
  std::error_code error;
  fs::remove(path_of(key, kind), error);
}

Cache::Contents Cache::contents() const {
  std::error_code error;
  const fs::directory_iterator readable(folder_, error);
  if (error && error != std::errc::no_such_file_or_directory &&
      error != std::errc::not_a_directory)
    throw std::runtime_error(fmt::format("cache {}: cannot be read ({})",
                                         folder_.string(), error.message()));
  const std::vector<Entry> entries = entries_of(folder_);
  return {entries.size(), total_bytes_of(entries)};
}

std::vector<std::string> Cache::problems() const {
  std::vector<std::string> found;
  if (damaged_ > 0)
    found.push_back(fmt::format(
        "cache {}: {} damaged entries were removed and computed again",
        folder_.string(), damaged_.load()));
  if (refused_ > 0)
    found.push_back(fmt::format(
        "cache {}: {} entries could not be written and are not cached",
        folder_.string(), refused_.load()));
  return found;
}

void Cache::clear() {
  std::vector<fs::path> gone;
  for_each_file(folder_, [&](const fs::directory_entry& file) {
    if (is_entry(file.path()) || is_left_over(file))
      gone.push_back(file.path());
  });
  std::size_t n_left = 0;
  std::string why;
  for (const fs::path& path : gone) {
    std::error_code error;
    fs::remove(path, error);
    if (!error)
      continue;
    ++n_left;
    why = error.message();
  }
  const std::lock_guard lock(mutex_);
  bytes_.reset();
  if (n_left > 0)
    throw std::runtime_error(
        fmt::format("cache {}: {} of {} entries could not be removed ({})",
                    folder_.string(), n_left, gone.size(), why));
}

fs::path cache_folder() {
  const auto given = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value == nullptr ? "" : value);
  };
  if (fs::path own = given("ASPERITY_CACHE"); !own.empty())
    return own;
  if (const fs::path shared = given("XDG_CACHE_HOME"); !shared.empty())
    return shared / "asperity";
  const fs::path home = given("HOME");
  return home.empty() ? home : home / ".cache" / "asperity";
}

std::uintmax_t cache_size() {
  const char* value = std::getenv("ASPERITY_CACHE_SIZE");
  if (value == nullptr || *value == '\0')
    return default_size;
  const std::string_view text(value);
  const auto [number, rest] = number_and_rest(text);
  const std::string unit = trimmed(rest);
  const double scale = unit.empty()   ? 1.0
                       : unit == "kB" ? 1e3
                       : unit == "MB" ? 1e6
                       : unit == "GB" ? 1e9
                       : unit == "TB" ? 1e12
                                      : -1.0;
  if (scale < 0.0 || !(number >= 0.0) || !(number * scale < 1e18))
    throw input::InputError(
        fmt::format("ASPERITY_CACHE_SIZE = \"{}\", but must be a size such as "
                    "500 MB or 2 GB, or 0 for no cache",
                    text));
  return static_cast<std::uintmax_t>(number * scale);
}

} // namespace asperity::methods
