#include "base/read_file.hpp"

#include "base/file_descriptor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace asperity {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
  throw FileError(path.string() + ": " + what);
}

[[noreturn]] void refuse_system(const fs::path& path, int error) {
  refuse(path,
         "cannot be read (" + std::generic_category().message(error) + ")");
}

const char* description(fs::file_type type) {
  switch (type) {
  case fs::file_type::directory:
    return "a folder";
  case fs::file_type::fifo:
    return "a pipe";
  case fs::file_type::socket:
    return "a socket";
  default:
    return "a device";
  }
}

/// O_NONBLOCK prevents waiting for a writer if a pipe has just replaced the
/// file.
FileDescriptor opened(const fs::path& path) {
  FileDescriptor file(
      ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (file.get() < 0)
    refuse_system(path, errno);
  return file;
}

} // namespace

void require_regular_file(const fs::path& path, std::uintmax_t largest) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found)
    refuse(path, fs::is_symlink(fs::symlink_status(path))
                     ? "is a link to a file that does not exist"
                     : "there is no such file");
  if (status.type() == fs::file_type::none)
    refuse_system(path, error.value());
  if (status.type() != fs::file_type::regular)
    refuse(path, fmt::format("is {}, but must be a regular file",
                             description(status.type())));
  const std::uintmax_t size = fs::file_size(path, error);
  if (error)
    refuse_system(path, error.value());
  if (size > largest)
    refuse(path,
           fmt::format("has {} bytes, but must have at most {} ({})", size,
                       largest, bytes_text(static_cast<double>(largest))));
}

std::string read_file(const fs::path& path, std::uintmax_t largest) {
  require_regular_file(path, largest);
  const FileDescriptor file = opened(path);
  std::string content(std::min(fs::file_size(path), largest), '\0');
  std::size_t length = 0;
  for (;;) {
    if (length == content.size()) // an extra byte detects the end of the file
      content.resize(length + 4096);
    const ssize_t count =
        ::read(file.get(), content.data() + length, content.size() - length);
    if (count < 0 && errno != EINTR)
      refuse_system(path, errno);
    if (count == 0)
      break;
    length += count > 0 ? static_cast<std::size_t>(count) : 0;
    if (length > largest)
      refuse(path,
             fmt::format("has more than {} bytes, but must have at most "
                         "as many ({})",
                         largest, bytes_text(static_cast<double>(largest))));
  }
  content.resize(length);
  return content;
}

std::string bytes_text(double bytes) {
  constexpr const char* units[] = {"bytes", "KiB", "MiB", "GiB", "TiB", "PiB"};
  std::size_t unit = 0;
  while (bytes >= 1024.0 && unit + 1 < std::size(units)) {
    bytes /= 1024.0;
    ++unit;
  }
  return fmt::format("{:.4g} {}", bytes, units[unit]);
}

} // namespace asperity
