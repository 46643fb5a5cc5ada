#pragma once

// Gives access to the bytes of a file without reading all of them.

#include "base/file_descriptor.hpp"
#include "input/input_error.hpp"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <sys/stat.h>

namespace asperity::input {

/// The bytes of a file, of which only those that are looked at come into
/// memory. The file must not become shorter meanwhile, so that this is for
/// headers, which are read at once, and not for numbers, which are read later.
class MappedFile {
public:
  /// @param path  of a regular file (require_regular_file())
  /// @throws InputError  the file cannot be opened or mapped
  explicit MappedFile(const std::string& path) {
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));

    struct stat facts {};

    if (file.get() < 0 || ::fstat(file.get(), &facts) != 0)
      refuse(path);
    size_ = static_cast<std::size_t>(facts.st_size);
    if (size_ == 0)
      return; // nothing can be mapped
    begin_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE, file.get(), 0);
    if (begin_ == MAP_FAILED)
      refuse(path);
  }

  ~MappedFile() {
    if (size_ > 0)
      ::munmap(begin_, size_);
  }

  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const {
    return {static_cast<const char*>(begin_), size_};
  }

private:
  [[noreturn]] static void refuse(const std::string& path) {
    throw InputError(path + ": cannot be read (" + std::strerror(errno) + ")");
  }

  void* begin_ = nullptr;
  std::size_t size_ = 0;
};

} // namespace asperity::input
