#pragma once

#include <unistd.h>
#include <utility>

namespace asperity {

/// Owner of a file descriptor, which is closed by the destructor.
class FileDescriptor {
public:
  FileDescriptor() = default;

  explicit FileDescriptor(int number) : number_(number) {}

  ~FileDescriptor() { reset(); }

  FileDescriptor(FileDescriptor&& other) noexcept
      : number_(std::exchange(other.number_, -1)) {}

  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  /// The descriptor, or -1 if there is none.
  int get() const { return number_; }

  void reset() {
    if (number_ >= 0)
      ::close(std::exchange(number_, -1));
  }

private:
  int number_ = -1;
};

} // namespace asperity
