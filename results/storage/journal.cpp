#include "results/storage/journal.hpp"

#include "base/content_hash.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace asperity::results {
namespace {

constexpr std::size_t hash_length = 64;
constexpr std::chrono::seconds longest_unsynced{10};

/// Header of a record.
struct RecordHead {
  std::uint64_t length = 0;
  std::uint64_t number = 0;
  char hash[hash_length] = {};
};

std::string head_of(const std::string& identity) {
  return "asperity-journal-1 " + identity + "\n";
}

/// @param hash  of the bytes of the record
std::string hash_of(std::uint64_t number, const std::string& hash) {
  return content_hash(std::to_string(number) + " " + hash);
}

template <class Object>
std::span<char> bytes_of(Object& object) {
  return {reinterpret_cast<char*>(&object), sizeof object};
}

} // namespace

std::filesystem::path journal_of(const std::filesystem::path& result_file) {
  std::filesystem::path path = result_file;
  return path.replace_extension(".journal");
}

std::uintmax_t read_journal(const std::filesystem::path& path,
                            const std::string& identity,
                            const TakeRecord& take) {
  const std::optional<FileBytes> file = FileBytes::of(path);
  const std::string head = head_of(identity);
  std::string found(head.size(), '\0');
  if (!file || file->read_some(0, found) < head.size() || found != head)
    return 0;
  std::uintmax_t whole = head.size();
  RecordHead record;
  while (file->read_some(whole, bytes_of(record)) == sizeof record) {
    const std::uintmax_t begin = whole + sizeof record;
    if (record.length > file->size() - begin)
      break;
    const FileBytes bytes = file->part(begin, record.length);
    if (hash_of(record.number, bytes.hash()) !=
        std::string_view(record.hash, hash_length))
      break;
    take(record.number, bytes);
    whole = begin + record.length;
  }
  return whole;
}

Journal::Journal(std::filesystem::path path, std::string identity)
    : path_(std::move(path)), identity_(std::move(identity)) {
  size_ =
      read_journal(path_, identity_, [](std::uint64_t, const FileBytes&) {});
}

void Journal::open() {
  file_ = FileDescriptor(
      ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
  if (file_.get() < 0 || ftruncate(file_.get(), static_cast<off_t>(size_)) != 0)
    throw std::system_error(errno, std::generic_category(),
                            "cannot write " + path_.string());
  if (size_ == 0) {
    const std::string head = head_of(identity_);
    write(0, head);
    size_ = head.size();
  }
}

void Journal::write(std::uintmax_t place, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_.get(), bytes.data(), bytes.size(),
                                   static_cast<off_t>(place));
    if (written < 0 && errno != EINTR)
      throw std::system_error(errno, std::generic_category(),
                              "cannot write " + path_.string());
    const auto done = static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    bytes.remove_prefix(done);
    place += done;
  }
}

void Journal::append(std::uint64_t number, const BytePieces& bytes) {
  if (file_.get() < 0 || size_ == 0)
    open();
  RecordHead record{0, number, {}};
  const std::uintmax_t begin = size_ + sizeof record;
  ContentHash hash;
  try {
    bytes([&](std::string_view piece) {
      hash.add(piece);
      write(begin + record.length, piece);
      record.length += piece.size();
    });
    std::memcpy(record.hash, hash_of(number, hash.text()).data(), hash_length);
    const std::span<const char> head = bytes_of(record);
    write(size_, {head.data(), head.size()});
  } catch (...) {
    if (ftruncate(file_.get(), static_cast<off_t>(size_)) != 0) {
      // A damaged record at the end is ignored by readers and will be
      // overwritten.
    }
    throw;
  }
  size_ = begin + record.length;
  if (Clock::now() - synced_ < longest_unsynced)
    return;
  if (fdatasync(file_.get()) != 0)
    throw std::system_error(errno, std::generic_category(),
                            "cannot write " + path_.string());
  synced_ = Clock::now();
}

void Journal::clear() {
  file_.reset();
  std::filesystem::remove(path_);
  size_ = 0;
}

} // namespace asperity::results
