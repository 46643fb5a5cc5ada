#include "results/storage/journal.hpp"

#include "base/content_hash.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fstream>
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

std::string hash_of(std::uint64_t number, std::string_view bytes) {
  return content_hash(std::to_string(number) + " " + content_hash(bytes));
}

} // namespace

std::filesystem::path journal_of(const std::filesystem::path& result_file) {
  std::filesystem::path path = result_file;
  return path.replace_extension(".journal");
}

std::uintmax_t read_journal(const std::filesystem::path& path,
                            const std::string& identity,
                            const TakeRecord& take) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) // missing, or not a regular file
    return 0;
  std::ifstream file(path, std::ios::binary);
  const std::string head = head_of(identity);
  std::string found(head.size(), '\0');
  if (!file.read(found.data(), std::ssize(found)) || found != head)
    return 0;
  std::uintmax_t whole = head.size();
  RecordHead record;
  std::string bytes;
  while (file.read(reinterpret_cast<char*>(&record), sizeof record) &&
         record.length <= size &&
         whole + sizeof record + record.length <= size) {
    bytes.resize(record.length);
    if (!file.read(bytes.data(), std::ssize(bytes)) ||
        hash_of(record.number, bytes) !=
            std::string_view(record.hash, hash_length))
      break;
    take(record.number, bytes);
    whole += sizeof record + bytes.size();
  }
  return whole;
}

Journal::Journal(std::filesystem::path path, std::string identity)
    : path_(std::move(path)), identity_(std::move(identity)) {
  size_ =
      read_journal(path_, identity_, [](std::uint64_t, std::string_view) {});
}

void Journal::open() {
  file_ = FileDescriptor(
      ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666));
  if (file_.get() < 0 || ftruncate(file_.get(), static_cast<off_t>(size_)) != 0)
    throw std::system_error(errno, std::generic_category(),
                            "cannot write " + path_.string());
  if (size_ == 0)
    write(head_of(identity_));
}

/// Writes all bytes, or none if an error occurs.
void Journal::write(std::string_view bytes) {
  std::uintmax_t place = size_;
  while (!bytes.empty()) {
    const ssize_t written = pwrite(file_.get(), bytes.data(), bytes.size(),
                                   static_cast<off_t>(place));
    if (written < 0 && errno != EINTR) {
      const int error = errno;
      if (ftruncate(file_.get(), static_cast<off_t>(size_)) != 0) {
        // A damaged record at the end is ignored by readers and will be
        // overwritten.
      }
      throw std::system_error(error, std::generic_category(),
                              "cannot write " + path_.string());
    }
    const auto done = static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    bytes.remove_prefix(done);
    place += done;
  }
  size_ = place;
}

void Journal::append(std::uint64_t number, std::string_view bytes) {
  if (file_.get() < 0)
    open();
  RecordHead record{bytes.size(), number, {}};
  std::memcpy(record.hash, hash_of(number, bytes).data(), hash_length);
  std::string whole(reinterpret_cast<const char*>(&record), sizeof record);
  whole += bytes;
  write(whole);
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
