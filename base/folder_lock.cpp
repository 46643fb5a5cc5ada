#include "base/folder_lock.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/utsname.h>
#include <system_error>
#include <thread>
#include <unistd.h>

namespace asperity {
namespace {

std::string description_of(const std::string& purpose) {
  utsname host{};
  uname(&host);
  const std::time_t now =
      std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{} (process {} on {}, since {:%Y-%m-%dT%H:%M:%SZ})",
                     purpose, getpid(), host.nodename, fmt::gmtime(now));
}

/// Description of the process that holds the lock. It is written just after the
/// file has been locked, so an empty file is read again for up to a second.
std::string holder_in(int file) {
  constexpr int tries = 50;
  for (int i = 0; i < tries; ++i) {
    char text[1024];
    const ssize_t length = pread(file, text, sizeof text, 0);
    if (length > 0)
      return {text, static_cast<std::size_t>(length)};
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return "another process";
}

/// Tries to lock for half a second, because a holder that was killed may still
/// be ending.
bool lock_soon(int file) {
  constexpr int tries = 10;
  for (int i = 1; i < tries; ++i) {
    if (flock(file, LOCK_EX | LOCK_NB) == 0)
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return flock(file, LOCK_EX | LOCK_NB) == 0;
}

/// The folder and its parents that do not exist yet, the deepest first.
/// @throws UnusableFolder  one of them is a file
std::vector<std::filesystem::path>
missing_folders(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> missing;
  auto at = std::filesystem::absolute(folder);
  for (; !std::filesystem::exists(at); at = at.parent_path())
    missing.push_back(at);
  if (!std::filesystem::is_directory(at))
    throw UnusableFolder(fmt::format(
        "{} is a file, not a folder; name another --out", at.string()));
  return missing;
}

/// Refuses a file of that name that no lock has left.
/// @throws UnusableFolder
void require_lock_file(const std::filesystem::path& path, int file) {
  char text[1024];
  const ssize_t length = pread(file, text, sizeof text, 0);
  if (length != 0 && std::string_view(text, static_cast<std::size_t>(
                                                std::max<ssize_t>(length, 0)))
                             .find("(process ") == std::string_view::npos)
    throw UnusableFolder(fmt::format(
        "{} is there already, and no lock of this program has left it; move it "
        "away, or name another --out",
        path.string()));
}

/// Whether the open file still is the one at this path: a former holder removes
/// the file when it ends.
bool is_still_at(const std::filesystem::path& path, int file) {
  struct stat opened {};

  struct stat named {};

  return fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_ino == named.st_ino && opened.st_dev == named.st_dev;
}

} // namespace

FolderLock::FolderLock(const std::filesystem::path& folder,
                       const std::string& purpose)
    : path_(folder / ".lock"), made_(missing_folders(folder)) {
  const auto check = [&](bool is_good, const char* what) {
    if (!is_good)
      throw std::system_error(errno, std::generic_category(),
                              what + path_.string());
  };
  do {
    std::filesystem::create_directories(folder);
    file_ = FileDescriptor(
        open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    check(file_.get() >= 0, "cannot write ");
    require_lock_file(path_, file_.get());
    const bool is_ours = lock_soon(file_.get());
    if (!is_ours && errno == EWOULDBLOCK)
      throw UnusableFolder(fmt::format(
          "{} is in use by {}; wait for its end, or name another --out",
          folder.string(), holder_in(file_.get())));
    check(is_ours, "cannot lock ");
  } while (!is_still_at(path_, file_.get()));
  const std::string text = description_of(purpose);
  check(ftruncate(file_.get(), 0) == 0 &&
            pwrite(file_.get(), text.data(), text.size(), 0) ==
                static_cast<ssize_t>(text.size()),
        "cannot write ");
}

FolderLock::~FolderLock() {
  if (file_.get() < 0)
    return;
  std::error_code ignored; // a folder that is not empty remains
  std::filesystem::remove(path_, ignored);
  for (const std::filesystem::path& folder : made_)
    if (!std::filesystem::remove(folder, ignored))
      break;
}

} // namespace asperity
