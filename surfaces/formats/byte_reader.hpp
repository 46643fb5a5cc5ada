#pragma once

// Reads numbers and texts one after the other from the bytes of a binary file.
// Every access is checked against the end of the file.

#include "input/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

namespace asperity::surfaces {

/// A position in the bytes of a file or of a part of it.
class ByteReader {
public:
  /// @param name    of the file, for messages
  /// @param offset  of the first byte in the file, for messages
  ByteReader(std::string_view bytes, std::string name, std::size_t offset = 0)
      : bytes_(bytes), name_(std::move(name)), start_(offset) {}

  bool is_at_end() const { return at_ == bytes_.size(); }

  std::size_t remaining() const { return bytes_.size() - at_; }

  std::size_t offset() const { return start_ + at_; }

  const std::string& name() const { return name_; }

  /// Takes the next `count` bytes.
  /// @throws input::InputError  there are fewer
  std::string_view take_bytes(std::size_t count) {
    if (count > remaining())
      refuse(fmt::format("ends here, but {} more bytes must follow",
                         count - remaining()));
    const std::string_view taken = bytes_.substr(at_, count);
    at_ += count;
    return taken;
  }

  /// Numbers are big-endian from here on.
  void expect_big_endian() { is_big_endian_ = true; }

  /// Skips the next `count` bytes.
  void skip(std::size_t count) { (void)take_bytes(count); }

  /// Takes a number, little-endian unless expect_big_endian() was called.
  template <class Number>
  Number take() {
    static_assert(std::endian::native == std::endian::little);
    std::array<char, sizeof(Number)> taken{};
    std::ranges::copy(take_bytes(taken.size()), taken.begin());
    if (is_big_endian_)
      std::ranges::reverse(taken);
    return std::bit_cast<Number>(taken);
  }

  /// Takes a text that ends with a zero byte, which is taken too.
  std::string_view take_text() {
    const std::size_t end = bytes_.find('\0', at_);
    if (end == std::string_view::npos)
      refuse("a text without its final zero byte");
    const std::string_view text = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return text;
  }

  /// @throws input::InputError  "name: byte N: what"
  [[noreturn]] void refuse(const std::string& what) const {
    throw input::InputError(
        fmt::format("{}: byte {}: {}", name_, offset(), what));
  }

private:
  std::string_view bytes_;
  std::string name_;
  std::size_t start_;
  std::size_t at_ = 0;
  bool is_big_endian_ = false;
};

} // namespace asperity::surfaces
