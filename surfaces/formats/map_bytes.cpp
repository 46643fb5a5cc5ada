#include "surfaces/formats/map_bytes.hpp"

#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace asperity::surfaces {

MapBytes MapBytes::of_file(const std::string& path) {
  try {
    require_regular_file(path, input::largest_number_file);
  } catch (const FileError& error) {
    throw input::InputError(error.what());
  }
  MapBytes bytes({}, path);
  bytes.file_ = FileBytes::of(path);
  if (!bytes.file_)
    throw input::InputError(path + ": cannot be read (" +
                            std::generic_category().message(errno) + ")");
  bytes.size_ = bytes.file_->size();
  return bytes;
}

std::string MapBytes::beginning() const {
  constexpr std::uintmax_t most = std::uintmax_t{1} << 16;
  return piece(0, static_cast<std::size_t>(std::min(most, size_)));
}

std::string_view MapBytes::all() const {
  if (!file_)
    return all_;
  if (read_ == nullptr)
    read_ = std::make_shared<const std::string>(
        input::read_input_file(name_, input::largest_number_file));
  return *read_;
}

std::string MapBytes::piece(std::uintmax_t begin, std::size_t count) const {
  std::string bytes(count, '\0');
  if (file_) {
    if (file_->read_some(begin, bytes) == count)
      return bytes;
  } else if (begin <= all_.size() && count <= all_.size() - begin) {
    return std::string(all_.substr(static_cast<std::size_t>(begin), count));
  }
  throw input::InputError(name_ + ": cannot be read to its end");
}

std::vector<double> StoredNumbers::rows(int first, int count) const {
  const std::size_t row_bytes = columns * width;
  const std::size_t at_a_time =
      std::max<std::size_t>(1, piece_bytes / row_bytes);
  const auto first_row = static_cast<std::size_t>(first);
  const auto n_rows = static_cast<std::size_t>(count);
  std::vector<double> heights(n_rows * columns);
  for (std::size_t row = 0; row < n_rows; row += at_a_time) {
    const std::size_t n = std::min(at_a_time, n_rows - row);
    convert(bytes.piece(begin + (first_row + row) * row_bytes, n * row_bytes),
            std::span(heights).subspan(row * columns, n * columns));
  }
  for (double& height : heights)
    height *= height_unit;
  return heights;
}

} // namespace asperity::surfaces
