#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "surfaces/formats/known_file.hpp"
#include "surfaces/formats/own_readers.hpp"
#include "surfaces/formats/text/list_points.hpp"
#include "surfaces/formats/text/number_table.hpp"
#include "surfaces/formats/text/text_header.hpp"
#include "surfaces/formats/text/xyz_list.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

namespace asperity::surfaces {
namespace {

using mechanics::MapFormat;

/// Where the rows of a text are, and what else it says.
struct TextIndex {
  NumberTable table;                 ///< without its numbers
  std::vector<std::uint64_t> begins; ///< first byte of each row
  std::size_t missing = 0;           ///< points without a height
  double largest = 0.0;              ///< magnitude of the numbers
  bool has_zero_byte = false;        ///< it is no text then
  /// If it may be a list x y z, of which nothing else is known then.
  std::optional<ListOrder> list;
  bool is_in_order = true; ///< the list, or what was read of it
};

void take_heights(std::span<const double> numbers, TextIndex& index) {
  for (const double number : numbers) {
    if (std::isnan(number))
      ++index.missing;
    else
      index.largest = std::max(index.largest, std::abs(number));
  }
}

/// @param may_be_list  three columns are x y z
TextIndex index_of_text(const std::string& path, bool may_be_list) {
  TextIndex index;
  NumberTableReader reader(path, NumberStyle::instrument);
  each_line(path, 0, [&](std::string_view line, std::uint64_t begin) {
    index.has_zero_byte = line.find('\0') != std::string_view::npos;
    if (index.has_zero_byte)
      return false;
    const std::size_t before = reader.rows();
    reader.take(line);
    if (reader.rows() == before)
      return true;
    std::vector<double> numbers = reader.numbers_so_far();
    if (may_be_list && numbers.size() == list_columns) {
      if (!index.list)
        index.list.emplace();
      index.is_in_order =
          index.list->take(numbers[0], numbers[1], begin, reader.line());
      reader.forget_lines(); // of each point
      numbers.erase(numbers.begin(), numbers.begin() + 2);
    } else {
      index.begins.push_back(begin);
    }
    take_heights(numbers, index);
    return index.is_in_order;
  });
  if (index.list)
    index.list->set_rounding(reader.rounding());
  if (!index.has_zero_byte)
    index.table = reader.finish();
  index.is_in_order =
      index.is_in_order && (!index.list || index.list->is_grid());
  return index;
}

std::shared_ptr<const TextIndex> known_index(const std::string& path,
                                             bool may_be_list) {
  return known_of_file<TextIndex>(
      path, may_be_list, [&] { return index_of_text(path, may_be_list); });
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

/// The heights of some rows of a list, which are adjacent in the file.
std::vector<double> list_rows(const std::string& path, const TextIndex& index,
                              double unit, int first, int count) {
  const ListOrder& list = *index.list;
  const int first_in_file = list.is_reversed() ? first + count - 1 : first;
  const auto [begin, line] = list.row(first_in_file);
  const std::size_t width = list.columns();
  const std::size_t size = width * static_cast<std::size_t>(count);
  NumberTableReader reader(path, NumberStyle::instrument);
  reader.continue_at(line - 1, list_columns);
  std::vector<double> heights;
  heights.reserve(size);
  each_line(path, begin, [&](std::string_view text, std::uint64_t) {
    reader.take(text);
    const std::vector<double> numbers = reader.numbers_so_far();
    reader.forget_lines();
    if (!numbers.empty())
      heights.push_back(unit * numbers.back());
    return heights.size() < size;
  });
  if (heights.size() != size)
    throw input::InputError(path +
                            ": has fewer points than when the run began");
  if (list.is_reversed()) { // last row first
    std::ranges::reverse(heights);
    for (auto row = heights.begin(); row != heights.end();
         row += static_cast<std::ptrdiff_t>(width))
      std::reverse(row, row + static_cast<std::ptrdiff_t>(width));
  }
  return heights;
}

RowFile ordered_list_file(const std::string& path, const ScanRequest& request,
                          const std::shared_ptr<const TextIndex>& index) {
  RowFile file{index->list->grid(path, request.scale), "", list_reader, {}};
  const double unit = *request.scale.height_unit;
  file.numbers.unit = unit;
  file.rows = [path, index, unit](int first, int count) {
    return list_rows(path, *index, unit, first, count);
  };
  if (std::isfinite(index->largest * unit))
    file.missing = index->missing;
  return file;
}

RowFile matrix_file(const std::string& path, const ScanRequest& request,
                    const std::shared_ptr<const TextIndex>& index) {
  TextMatrix matrix = text_matrix(index->table, request);
  RowFile file;
  file.grid = matrix.grid;
  file.channel = std::move(matrix.channel);
  file.reader = std::move(matrix.reader);
  file.numbers = {.unit = matrix.height_unit, .missing = matrix.missing_value};
  file.rows = [path, index, unit = matrix.height_unit](int first, int count) {
    return text_rows(path, *index, unit, first, count);
  };
  if (std::isfinite(index->largest * matrix.height_unit))
    file.missing = index->missing;
  return file;
}

/// Calls take(point) for each line of a text of three columns.
/// @param zero_byte  set if there is one: it is no text then
/// @return  the other lines
NumberTable each_text_point(const std::string& path, const TakePoint& take,
                            bool& zero_byte) {
  NumberTableReader reader(path, NumberStyle::instrument);
  each_line(path, 0, [&](std::string_view line, std::uint64_t) {
    zero_byte = line.find('\0') != std::string_view::npos;
    if (zero_byte)
      return false;
    reader.take(line);
    const std::vector<double> numbers = reader.numbers_so_far();
    reader.forget_lines(); // of each point
    if (numbers.empty())
      return true;
    if (numbers.size() != list_columns)
      FileStamp::refuse_changed(path);
    return take(
        {numbers[0], numbers[1], numbers[2], reader.line(), reader.rounding()});
  });
  return zero_byte ? NumberTable() : reader.finish();
}

/// A list whose points are in any order, and the header of its file.
struct ScatteredList {
  std::shared_ptr<const ListIndex> index;
  NumberTable table; ///< without its numbers
  bool has_zero_byte = false;
};

ListSource text_source(const std::string& path, ScatteredList* found) {
  return {path, path, [path, found](const TakePoint& take) {
            bool zero_byte = false;
            NumberTable table = each_text_point(path, take, zero_byte);
            if (found != nullptr) {
              found->table = std::move(table);
              found->has_zero_byte = found->has_zero_byte || zero_byte;
            }
          }};
}

ScatteredList scattered_list(const std::string& path) {
  ScatteredList found;
  found.index = std::make_shared<const ListIndex>(
      index_of_list(text_source(path, &found)));
  return found;
}

/// A text of three columns that is no list in the order of its rows: another
/// list, or a matrix.
std::optional<RowFile> scattered_file(const std::string& path,
                                      const ScanRequest& request) {
  const auto found = known_of_file<ScatteredList>(
      path, 0, [&] { return scattered_list(path); });
  if (found->has_zero_byte)
    return std::nullopt;
  const ListIndex& index = *found->index;
  if (request.format == MapFormat::automatic) {
    const bool is_matrix =
        gwyddion_header(found->table).width.line != 0 || index.points < 4;
    if (is_matrix)
      return matrix_file(path, request, known_index(path, false));
    if (!index.is_list())
      refuse_possible_list(path, list_columns, index.points);
    require_list_header(found->table, request.scale);
  }
  return list_row_file(text_source(path, nullptr), found->index, request.scale);
}

} // namespace

std::optional<RowFile> text_row_file(const std::string& path,
                                     const ScanRequest& request) {
  const bool is_automatic = request.format == MapFormat::automatic;
  const bool is_list = request.format == MapFormat::xyz;
  const std::shared_ptr<const TextIndex> index =
      known_index(path, is_automatic || is_list);
  if (index->has_zero_byte)
    return std::nullopt;
  std::optional<RowFile> file;
  if (index->list && index->is_in_order &&
      (is_list || gwyddion_header(index->table).width.line == 0)) {
    if (is_automatic)
      require_list_header(index->table, request.scale);
    file = ordered_list_file(path, request, index);
  } else if (index->list) {
    file = scattered_file(path, request);
  } else {
    if (is_list)
      require_list_columns(index->table);
    const bool is_plain =
        is_automatic && gwyddion_header(index->table).width.line == 0;
    if (is_plain && index->table.columns == fourier_columns &&
        fourier_points(read_number_text(
            input::read_input_file(path, input::largest_number_file), path,
            NumberStyle::instrument)) > 0)
      return std::nullopt; // its heights are sums over all lines
    if (is_plain)
      refuse_possible_list(path, index->table.columns, index->table.rows());
    file = matrix_file(path, request, index);
  }
  return file && !names_another(request.channel, file->channel) ? file
                                                                : std::nullopt;
}

} // namespace asperity::surfaces
