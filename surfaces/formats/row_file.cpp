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
  file.rows = [numbers = StoredNumbers{
                   path, layout.begin, layout.width, layout.columns,
                   *request.scale.height_unit,
                   [layout](std::string_view bytes, std::span<double> taken) {
                     npy_numbers(layout, bytes, taken);
                   }}](int first, int count) {
    return stored_rows(numbers, first, count);
  };
  return file;
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
  if (format == MapFormat::gwy)
    return gwy_row_file(path, request);
  if (format == MapFormat::sdf)
    return sdf_row_file(path, beginning, request);
  if (format == MapFormat::automatic || format == MapFormat::plain ||
      format == MapFormat::gwyddion || format == MapFormat::xyz)
    return text_row_file(path, request);
  return std::nullopt;
}

} // namespace asperity::surfaces
