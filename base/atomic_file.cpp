#include "base/atomic_file.hpp"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <string>
#include <system_error>
#include <unistd.h>

namespace asperity {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path) {
  throw std::system_error(errno, std::generic_category(),
                          "cannot write " + path.string());
}

/// Returns true if all of `text` was written; otherwise errno holds the reason.
bool write_all(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file, text.data(), text.size());
    if (written < 0 && errno != EINTR)
      return false;
    if (written > 0)
      text.remove_prefix(static_cast<std::size_t>(written));
  }
  return ::fsync(file) == 0 || errno == EINVAL || errno == EROFS; // a device
}

/// Writes to what is no file, such as a terminal, a pipe or /dev/null, which a
/// rename would replace.
void write_to_device(const std::filesystem::path& path, std::string_view text) {
  // A pipe that nobody reads is an error, not awaited.
  const int file =
      ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0 || ::fcntl(file, F_SETFL, 0) != 0)
    refuse(path);
  const bool is_written = write_all(file, text);
  const int write_error = errno;
  ::close(file);
  errno = write_error;
  if (!is_written)
    refuse(path);
}

/// Renames a temporary file that holds the text.
void replace_file(const std::filesystem::path& path, std::string_view text) {
  const std::filesystem::path temporary = temporary_beside(path);
  const int file =
      ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0)
    refuse(path);

  const bool is_written = write_all(file, text);
  const int write_error = errno;
  const bool is_closed = ::close(file) == 0;
  if (!is_written)
    errno = write_error;
  if (!is_written || !is_closed ||
      ::rename(temporary.c_str(), path.c_str()) != 0) {
    const int error = errno;
    ::unlink(temporary.c_str());
    errno = error;
    refuse(path);
  }
}

} // namespace

std::filesystem::path temporary_beside(const std::filesystem::path& path) {
  static std::atomic<int> count = 0;
  return path.parent_path() /
         ("." + path.filename().string() + "." + std::to_string(::getpid()) +
          "-" + std::to_string(count++) + ".part");
}

void write_file_atomically(const std::filesystem::path& path,
                           std::string_view text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_other(status))
    write_to_device(path, text);
  else if (fs::is_symlink(fs::symlink_status(path, error)) &&
           fs::exists(status))
    replace_file(fs::canonical(path), text);
  else
    replace_file(path, text);
}

} // namespace asperity
