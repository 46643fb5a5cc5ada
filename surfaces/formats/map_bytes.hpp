#pragma once

// This internal header of surfaces/formats gives access to the bytes of a map,
// in memory or in a file, as a whole or in pieces.

#include "base/file_bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity::surfaces {

/// The bytes of a map. Copies share what has been read.
class MapBytes {
public:
  /// Bytes in memory, which must outlive this object and its copies.
  /// @param name  of the file, for messages
  MapBytes(std::string_view bytes, std::string name)
      : name_(std::move(name)), size_(bytes.size()), all_(bytes) {}

  /// Bytes of a file, which are read when they are asked for.
  /// @throws input::InputError  the file is not a regular file that can be
  ///                            opened, or larger than
  ///                            input::largest_number_file
  static MapBytes of_file(const std::string& path);

  const std::string& name() const { return name_; }

  bool is_file() const { return file_.has_value(); }

  std::uintmax_t size() const { return size_; }

  /// The first 64 kB, enough for the header of any format but texts.
  std::string beginning() const;

  /// All bytes, which are then kept. They live as long as this object.
  /// @throws input::InputError  the file cannot be read
  std::string_view all() const;

  /// @throws input::InputError  there are fewer, because the file has become
  ///                            shorter
  std::string piece(std::uintmax_t begin, std::size_t count) const;

private:
  std::string name_;
  std::uintmax_t size_ = 0;
  std::string_view all_; ///< of bytes in memory
  std::optional<FileBytes> file_;
  mutable std::shared_ptr<const std::string> read_; ///< of a file
};

/// Numbers of a map that a file stores one after the other, row by row.
struct StoredNumbers {
  MapBytes bytes;
  std::uint64_t begin = 0;  ///< first byte
  std::size_t width = 8;    ///< of a number [bytes]
  std::size_t columns = 0;  ///< numbers of a row
  double height_unit = 1.0; ///< [m] per unit of the numbers
  /// Converts numbers.size() * width bytes.
  std::function<void(std::string_view bytes, std::span<double> numbers)>
      convert;

  /// Reads whole rows, by pieces of a MB or one row [m].
  /// @throws input::InputError  the file has become shorter
  std::vector<double> rows(int first, int count) const;
};

} // namespace asperity::surfaces
