#include "surfaces/formats/row_file.hpp"

#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "surfaces/formats/npy.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/scan_formats.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <span>

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
  return std::nullopt;
}

} // namespace asperity::surfaces
