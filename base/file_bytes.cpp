#include "base/file_bytes.hpp"

#include "base/content_hash.hpp"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace asperity {

std::optional<FileBytes> FileBytes::of(const std::filesystem::path& path) {
  FileBytes bytes;
  bytes.file_ = std::make_shared<const OpenFile>(OpenFile{
      path,
      FileDescriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK))});
  const int file = bytes.file_->descriptor.get();
  struct stat found = {};
  if (file < 0 || ::fstat(file, &found) != 0 || !S_ISREG(found.st_mode))
    return std::nullopt;
  bytes.size_ = static_cast<std::uintmax_t>(found.st_size);
  return bytes;
}

FileBytes FileBytes::part(std::uintmax_t begin, std::uintmax_t size) const {
  FileBytes bytes = *this;
  bytes.begin_ += begin;
  bytes.size_ = size;
  return bytes;
}

std::size_t FileBytes::read_some(std::uintmax_t place,
                                 std::span<char> bytes) const {
  const std::uintmax_t left = size_ - std::min(place, size_);
  const std::size_t most = std::min<std::uintmax_t>(bytes.size(), left);
  std::size_t done = 0;
  while (done < most) {
    const ssize_t count =
        ::pread(file_->descriptor.get(), bytes.data() + done, most - done,
                static_cast<off_t>(begin_ + place + done));
    if (count == 0 || (count < 0 && errno != EINTR))
      break;
    done += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
  }
  return done;
}

void FileBytes::read(std::uintmax_t place, std::span<char> bytes) const {
  if (read_some(place, bytes) < bytes.size())
    throw std::runtime_error(file_->path.string() + " has become shorter");
}

std::string FileBytes::hash() const {
  ContentHash hash;
  std::string piece(std::min<std::uintmax_t>(piece_bytes, size_), '\0');
  std::uintmax_t place = 0;
  while (const std::size_t count = read_some(place, piece)) {
    hash.add(std::string_view(piece).substr(0, count));
    place += count;
  }
  return hash.text();
}

} // namespace asperity
