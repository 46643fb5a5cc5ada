#pragma once

// This internal header of results/ serialises numbers and texts in the byte
// order of the machine. The writer and the reader have the same functions, so
// that one description of a layout serves both directions.

#include "input/input_error.hpp"

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::results {

class ByteWriter {
public:
  void number(const double& value) { raw(&value, sizeof value); }

  void number(const int& value) { number(static_cast<double>(value)); }

  void flag(const bool& value) { number(value ? 1 : 0); }

  void count(const std::size_t& value) {
    const std::uint64_t number = value;
    raw(&number, sizeof number);
  }

  void text(const std::string& value) {
    count(value.size());
    bytes_ += value;
  }

  void numbers(const std::vector<double>& values) {
    count(values.size());
    raw(values.data(), values.size() * sizeof(double));
  }

  /// Stores the values in single precision.
  void single_numbers(const std::vector<double>& values) {
    const std::vector<float> singles(values.begin(), values.end());
    count(singles.size());
    raw(singles.data(), singles.size() * sizeof(float));
  }

  std::string take() { return std::move(bytes_); }

private:
  void raw(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }

  std::string bytes_;
};

/// Every function throws input::InputError if the data end too early.
class ByteReader {
public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  void number(double& value) { raw(&value, sizeof value); }

  void number(int& value) {
    double read = 0.0;
    number(read);
    if (!(read >= -1e9 && read <= 1e9))
      refuse();
    value = static_cast<int>(read);
  }

  void flag(bool& value) {
    int read = 0;
    number(read);
    value = read != 0;
  }

  void count(std::size_t& value) {
    std::uint64_t number = 0;
    raw(&number, sizeof number);
    if (number > bytes_.size()) // every item has at least one byte
      refuse();
    value = number;
  }

  void text(std::string& value) {
    value.resize(size_of_items(1));
    raw(value.data(), value.size());
  }

  void numbers(std::vector<double>& values) {
    values.resize(size_of_items(sizeof(double)));
    raw(values.data(), values.size() * sizeof(double));
  }

  void single_numbers(std::vector<double>& values) {
    std::vector<float> singles(size_of_items(sizeof(float)));
    raw(singles.data(), singles.size() * sizeof(float));
    values.assign(singles.begin(), singles.end());
  }

  bool is_at_end() const { return bytes_.empty(); }

private:
  [[noreturn]] static void refuse() {
    throw input::InputError("a record of the journal has an unknown layout");
  }

  std::size_t size_of_items(std::size_t bytes_each) {
    std::size_t size = 0;
    count(size);
    if (size > bytes_.size() / bytes_each)
      refuse();
    return size;
  }

  void raw(void* data, std::size_t size) {
    if (size > bytes_.size())
      refuse();
    if (size > 0)
      std::memcpy(data, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }

  std::string_view bytes_;
};

} // namespace asperity::results
