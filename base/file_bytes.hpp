#pragma once

// Bytes that are passed on by pieces, because they may be too many for the
// memory: to a function, and from a part of a file.

#include "base/file_descriptor.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace asperity {

/// Receives the next bytes.
using TakeBytes = std::function<void(std::string_view)>;
/// Gives all bytes to a function, piece by piece.
using BytePieces = std::function<void(const TakeBytes&)>;

/// Number of bytes that are in memory at a time.
inline constexpr std::size_t piece_bytes = std::size_t{1} << 20;

/// A part of a file that is open for reading. It remains readable if the file
/// is removed. Copies share the open file; any thread may read.
class FileBytes {
public:
  /// All bytes that the file has now; nothing if it is no regular file that can
  /// be opened.
  static std::optional<FileBytes> of(const std::filesystem::path& path);

  std::uintmax_t size() const { return size_; }

  /// @param begin, size  must lie within these bytes
  FileBytes part(std::uintmax_t begin, std::uintmax_t size) const;

  /// Reads the bytes from `place` on.
  /// @return  their number, smaller than bytes.size() at the end
  std::size_t read_some(std::uintmax_t place, std::span<char> bytes) const;

  /// Fills `bytes` with those from `place` on.
  /// @throws std::runtime_error  naming the file: it has become shorter
  void read(std::uintmax_t place, std::span<char> bytes) const;

  /// The SHA-256 of the bytes, see content_hash(). The bytes of a file that has
  /// become shorter have another one.
  std::string hash() const;

private:
  struct OpenFile {
    std::filesystem::path path;
    FileDescriptor descriptor;
  };

  FileBytes() = default;

  std::shared_ptr<const OpenFile> file_;
  std::uintmax_t begin_ = 0;
  std::uintmax_t size_ = 0;
};

} // namespace asperity
