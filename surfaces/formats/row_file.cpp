#include "surfaces/formats/row_file.hpp"

#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "surfaces/formats/npy.hpp"
#include "surfaces/formats/number_table.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/scan_formats.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <span>
#include <utility>

namespace asperity::surfaces {
namespace {

using mechanics::MapFormat;

/// Most bytes of a file that are in memory besides the heights.
constexpr std::size_t piece_bytes = std::size_t{1} << 22;

/// Enough for the header of an .npy file of two dimensions.
constexpr std::size_t header_bytes = std::size_t{1} << 16;

std::string bytes_at(const std::string& path, std::uintmax_t at,
                     std::size_t count) {
  std::ifstream stream(path, std::ios::binary);
  std::string bytes(count, '\0');
  stream.seekg(static_cast<std::streamoff>(at));
  stream.read(bytes.data(), static_cast<std::streamsize>(count));
  if (!stream)
    throw input::InputError(path + ": cannot be read to its end");
  return bytes;
}

std::vector<double> npy_rows(const std::string& path, const NpyLayout& layout,
                             double unit, int first, int count) {
  const std::size_t row_bytes = layout.columns * layout.width;
  const std::size_t at_a_time =
      std::max<std::size_t>(1, piece_bytes / row_bytes);
  const auto begin = static_cast<std::size_t>(first);
  const auto n_rows = static_cast<std::size_t>(count);
  std::vector<double> heights(n_rows * layout.columns);
  for (std::size_t row = 0; row < n_rows; row += at_a_time) {
    const std::size_t n = std::min(at_a_time, n_rows - row);
    npy_numbers(
        layout,
        bytes_at(path, layout.begin + (begin + row) * row_bytes, n * row_bytes),
        std::span(heights).subspan(row * layout.columns, n * layout.columns));
  }
  for (double& height : heights)
    height *= unit;
  return heights;
}

std::optional<RowFile> npy_row_file(const std::string& path,
                                    std::string_view beginning,
                                    const ScanRequest& request) {
  const NpyLayout layout =
      npy_layout(beginning, std::filesystem::file_size(path), path);
  require_sound_grid(path, static_cast<std::int64_t>(layout.columns),
                     static_cast<std::int64_t>(layout.rows), 1.0,
                     layout.rows * layout.columns);
  const bool may_be_list =
      request.format == MapFormat::automatic && layout.columns <= 3;
  const bool has_other_channel =
      request.channel && !request.channel.value().empty();
  if (may_be_list || has_other_channel || layout.is_by_column)
    return std::nullopt;
  RowFile file;
  file.grid = grid_by_scale({static_cast<int>(layout.columns),
                             static_cast<int>(layout.rows), 0.0, 0.0},
                            path, "an .npy file", request.scale);
  file.reader = "own reader of .npy";
  file.rows = [path, layout, unit = *request.scale.height_unit](int first,
                                                                int count) {
    return npy_rows(path, layout, unit, first, count);
  };
  return file;
}

/// Bytes of a text that are in memory besides a line.
constexpr std::size_t text_piece = std::size_t{1} << 20;

/// Where the rows of a text are, and what else it says.
struct TextIndex {
  NumberTable table;                 ///< without its numbers
  std::vector<std::uint64_t> begins; ///< first byte of each row
  std::size_t missing = 0;           ///< points without a height
  double largest = 0.0;              ///< magnitude of the numbers
  bool has_zero_byte = false;        ///< it is no text then
};

/// Calls take(line, its first byte) -> bool for lines of a file until it
/// returns false.
template <class Take>
void each_line(const std::string& path, std::uint64_t begin, const Take& take) {
  std::ifstream stream(path, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(begin));
  if (!stream)
    throw input::InputError(path + ": cannot be read");
  std::string text; // from the byte `begin` on
  std::string piece(text_piece, '\0');
  for (bool is_last = false; !is_last;) {
    stream.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    text.append(piece, 0, static_cast<std::size_t>(stream.gcount()));
    is_last = stream.eof();
    if (!is_last && !stream)
      throw input::InputError(path + ": cannot be read to its end");
    std::size_t at = 0;
    while (at < text.size()) {
      const std::size_t end = text.find('\n', at);
      if (end == std::string::npos && !is_last)
        break;
      const std::size_t length = std::min(end, text.size()) - at;
      if (!take(std::string_view(text).substr(at, length), begin + at))
        return;
      at += std::min(length + 1, text.size() - at);
    }
    text.erase(0, at);
    begin += at;
  }
}

TextIndex index_of_text(const std::string& path) {
  TextIndex index;
  NumberTableReader reader(path, NumberStyle::instrument);
  each_line(path, 0, [&](std::string_view line, std::uint64_t begin) {
    index.has_zero_byte = line.find('\0') != std::string_view::npos;
    if (index.has_zero_byte)
      return false;
    const std::size_t before = reader.rows();
    reader.take(line);
    if (reader.rows() > before)
      index.begins.push_back(begin);
    for (const double number : reader.numbers_so_far()) {
      if (std::isnan(number))
        ++index.missing;
      else
        index.largest = std::max(index.largest, std::abs(number));
    }
    return true;
  });
  if (!index.has_zero_byte)
    index.table = reader.finish();
  return index;
}

/// The index of a file, found again only if the file has changed: several
/// steps of a run ask for the rows of one map.
std::shared_ptr<const TextIndex> known_index(const std::string& path) {
  struct Known {
    std::string path;
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type time;
    std::shared_ptr<const TextIndex> index;
  };

  static std::mutex mutex;
  static Known known;
  const std::lock_guard lock(mutex);
  const std::uintmax_t bytes = std::filesystem::file_size(path);
  const auto time = std::filesystem::last_write_time(path);
  if (known.index == nullptr || known.path != path || known.bytes != bytes ||
      known.time != time)
    known = {path, bytes, time,
             std::make_shared<const TextIndex>(index_of_text(path))};
  return known.index;
}

std::vector<double> text_rows(const std::string& path, const TextIndex& index,
                              double unit, int first, int count) {
  const auto begin = static_cast<std::size_t>(first);
  const auto n_rows = static_cast<std::size_t>(count);
  NumberTableReader reader(path, NumberStyle::instrument);
  reader.continue_at(index.table.lines.at(begin) - 1, index.table.columns);
  std::vector<double> heights;
  heights.reserve(n_rows * index.table.columns);
  each_line(path, index.begins.at(begin),
            [&](std::string_view line, std::uint64_t) {
              reader.take(line);
              const std::vector<double> numbers = reader.numbers_so_far();
              heights.insert(heights.end(), numbers.begin(), numbers.end());
              return heights.size() < n_rows * index.table.columns;
            });
  if (heights.size() != n_rows * index.table.columns)
    throw input::InputError(path + ": has fewer rows than when the run began");
  for (double& height : heights)
    height *= unit;
  return heights;
}

/// Nothing if the text may be a list x y z. The whole text is read once for the
/// places of its lines.
std::optional<RowFile> text_row_file(const std::string& path,
                                     const ScanRequest& request) {
  const std::shared_ptr<const TextIndex> index = known_index(path);
  const bool is_automatic = request.format == MapFormat::automatic;
  if (index->has_zero_byte || (is_automatic && index->table.columns <= 3))
    return std::nullopt;
  TextMatrix matrix = text_matrix(index->table, request);
  if (request.channel && *request.channel != matrix.channel)
    return std::nullopt;
  RowFile file;
  file.grid = matrix.grid;
  file.channel = std::move(matrix.channel);
  file.reader = std::move(matrix.reader);
  file.rows = [path, index, unit = matrix.height_unit](int first, int count) {
    return text_rows(path, *index, unit, first, count);
  };
  if (std::isfinite(index->largest * matrix.height_unit))
    file.missing = index->missing;
  return file;
}

} // namespace

std::optional<RowFile> row_file(const std::string& path,
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
                               ? recognised_format(beginning)
                               : request.format;
  if (format == MapFormat::npy)
    return npy_row_file(path, beginning, request);
  if (format == MapFormat::hdf5)
    return hdf5_row_file(path, request);
  if (format == MapFormat::automatic || format == MapFormat::plain ||
      format == MapFormat::gwyddion)
    return text_row_file(path, request);
  return std::nullopt;
}

} // namespace asperity::surfaces
