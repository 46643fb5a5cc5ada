#include "surfaces/formats/row_file.hpp"

#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "surfaces/formats/npy.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/scan_formats.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <utility>

namespace asperity::surfaces {
namespace {

using mechanics::MapFormat;

/// Most bytes of a file that are in memory besides the heights.
constexpr std::size_t piece_bytes = std::size_t{1} << 22;

/// Enough for the header of an .npy file of two dimensions.
constexpr std::size_t header_bytes = std::size_t{1} << 16;

std::string bytes_at(std::ifstream& stream, const std::string& path,
                     std::uintmax_t at, std::size_t count) {
  std::string bytes(count, '\0');
  stream.seekg(static_cast<std::streamoff>(at));
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  if (!stream)
    throw input::InputError(path + ": cannot be read to its end");
  return bytes;
}

std::string bytes_at(const std::string& path, std::uintmax_t at,
                     std::size_t count) {
  std::ifstream stream(path, std::ios::binary);
  return bytes_at(stream, path, at, count);
}

/// Whole rows of an .npy file in Fortran order [1]: a piece of each column.
/// Columns of one page are read with those beside them, which costs less than
/// to skip their other rows.
std::vector<double> rows_by_column(const std::string& path,
                                   const NpyLayout& layout, int first,
                                   int count) {
  constexpr std::size_t page_bytes = 4096;
  const auto begin = static_cast<std::size_t>(first);
  const auto n_rows = static_cast<std::size_t>(count);
  const std::size_t at_a_time =
      layout.rows * layout.width > page_bytes
          ? 1
          : std::max<std::size_t>(1,
                                  piece_bytes / (layout.rows * layout.width));
  std::ifstream stream(path, std::ios::binary);
  std::vector<double> numbers(n_rows * layout.columns);
  std::vector<double> column(n_rows);
  for (std::size_t x = 0; x < layout.columns; x += at_a_time) {
    const std::size_t n = std::min(at_a_time, layout.columns - x);
    const std::string bytes = bytes_at(
        stream, path, layout.begin + (x * layout.rows + begin) * layout.width,
        ((n - 1) * layout.rows + n_rows) * layout.width);
    for (std::size_t i = 0; i < n; ++i) {
      npy_numbers(
          layout,
          std::string_view(bytes).substr(i * layout.rows * layout.width),
          column);
      for (std::size_t row = 0; row < n_rows; ++row)
        numbers[row * layout.columns + x + i] = column[row];
    }
  }
  return numbers;
}

std::optional<RowFile> npy_file(const std::string& path,
                                std::string_view beginning,
                                const ScanRequest& request) {
  const NpyLayout layout =
      npy_layout(beginning, std::filesystem::file_size(path), path);
  require_sound_grid(path, static_cast<std::int64_t>(layout.columns),
                     static_cast<std::int64_t>(layout.rows), 1.0,
                     layout.rows * layout.columns);
  if (names_another(request.channel, ""))
    return std::nullopt;
  RowFile numbers;
  numbers.grid = {static_cast<int>(layout.columns),
                  static_cast<int>(layout.rows), 0.0, 0.0};
  numbers.rows = [path, layout](int first, int count) {
    if (layout.is_by_column)
      return rows_by_column(path, layout, first, count);
    return stored_rows({path, layout.begin, layout.width, layout.columns, 1.0,
                        [&](std::string_view bytes, std::span<double> taken) {
                          npy_numbers(layout, bytes, taken);
                        }},
                       first, count);
  };
  return npy_row_file(path, std::move(numbers), request);
}

/// Whether a file contains a word, by pieces.
bool has_word(const std::string& path, std::string_view word) {
  std::ifstream stream(path, std::ios::binary);
  std::string window, piece(piece_bytes, '\0');
  while (stream) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    window.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    if (window.find(word) != std::string::npos)
      return true;
    window.erase(0, window.size() - std::min(window.size(), word.size()));
  }
  return false;
}

/// As recognised_format() of the whole file, unless a text has a zero byte
/// behind its beginning.
MapFormat format_of_file(const std::string& path, std::string_view beginning) {
  const MapFormat format = recognised_format(beginning);
  return format == MapFormat::convert && is_zip(beginning) &&
                 has_word(path, x3p_member)
             ? MapFormat::x3p
             : format;
}

} // namespace

std::vector<double> stored_rows(const StoredNumbers& numbers, int first,
                                int count) {
  const std::size_t row_bytes = numbers.columns * numbers.width;
  const std::size_t at_a_time =
      std::max<std::size_t>(1, piece_bytes / row_bytes);
  const auto begin = static_cast<std::size_t>(first);
  const auto n_rows = static_cast<std::size_t>(count);
  std::vector<double> heights(n_rows * numbers.columns);
  for (std::size_t row = 0; row < n_rows; row += at_a_time) {
    const std::size_t n = std::min(at_a_time, n_rows - row);
    numbers.convert(
        bytes_at(numbers.path, numbers.begin + (begin + row) * row_bytes,
                 n * row_bytes),
        std::span(heights).subspan(row * numbers.columns, n * numbers.columns));
  }
  for (double& height : heights)
    height *= numbers.height_unit;
  return heights;
}

namespace {

/// The file without regard to numbers that mark missing points.
std::optional<RowFile> row_file_of_format(const std::string& path,
                                          const ScanRequest& request) {
  try {
    require_regular_file(path, input::largest_number_file);
  } catch (const FileError& error) {
    throw input::InputError(error.what());
  }
  const std::string beginning =
      bytes_at(path, 0,
               static_cast<std::size_t>(std::min<std::uintmax_t>(
                   header_bytes, std::filesystem::file_size(path))));
  const MapFormat format = request.format == MapFormat::automatic
                               ? format_of_file(path, beginning)
                               : request.format;
  if (format == MapFormat::x3p)
    return x3p_row_file(path, request);
  if (format == MapFormat::npy)
    return npy_file(path, beginning, request);
  if (format == MapFormat::hdf5)
    return hdf5_row_file(path, request);
  if (format == MapFormat::gwy)
    return gwy_row_file(path, request);
  if (format == MapFormat::sdf)
    return sdf_row_file(path, beginning, request);
  if (format == MapFormat::sur)
    return sur_row_file(path, beginning, request);
  if (format == MapFormat::wsxm)
    return wsxm_row_file(path, beginning, request);
  if (format == MapFormat::automatic || format == MapFormat::plain ||
      format == MapFormat::gwyddion || format == MapFormat::xyz)
    return text_row_file(path, request);
  return std::nullopt;
}

} // namespace

std::optional<RowFile> row_file(const std::string& path,
                                const ScanRequest& request) {
  std::optional<RowFile> file = row_file_of_format(path, request);
  if (!file || (!request.missing_value && !file->numbers.missing))
    return file;
  file->missing.reset();
  file->missing_in = {};
  file->rows = [rows = std::move(file->rows), numbers = file->numbers,
                value = request.missing_value](int first, int count) {
    std::vector<double> heights = rows(first, count);
    mark_missing_value(heights, numbers, value);
    return heights;
  };
  return file;
}

} // namespace asperity::surfaces
