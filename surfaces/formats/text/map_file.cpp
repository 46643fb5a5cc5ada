#include "base/plain_text.hpp"
#include "base/require.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/length_units.hpp"
#include "surfaces/formats/map_format.hpp"
#include "surfaces/formats/text/fourier_map.hpp"
#include "surfaces/formats/text/number_table.hpp"
#include "surfaces/formats/text/text_header.hpp"
#include "surfaces/formats/text/xyz_list.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <utility>

namespace asperity::surfaces {
namespace {

/// Converts a line such as "20.0 um" of Gwyddion's header to metres.
double header_length(const NumberTable& table, const CommentLine& line,
                     const char* key) {
  if (line.line == 0)
    throw input::InputError(fmt::format(
        "{}: no line '# {}: 20 um', which a Gwyddion text matrix begins with",
        table.name, key));
  const std::optional<double> length = length_of_text(line.text);
  if (!length || *length <= 0.0 || !std::isfinite(*length))
    refuse_line(table.name, line.line,
                fmt::format("{}: found '{}', but must be a number > 0 and a "
                            "unit of {}",
                            key, printable(line.text), known_length_units()));
  return *length;
}

double header_height_unit(const NumberTable& table, const CommentLine& line,
                          const MapScale& scale) {
  if (line.line == 0) {
    if (!scale.height_unit)
      throw input::InputError(fmt::format(
          "surface.height_unit is missing: {} has no line '# Value units: m'",
          table.name));
    return *scale.height_unit;
  }
  refuse_given("height_unit", scale.height_unit,
               fmt::format("line {} of {} gives '{}'", line.line, table.name,
                           printable(line.text)));
  const std::optional<double> metres = length_unit(line.text);
  if (!metres)
    refuse_line(table.name, line.line,
                fmt::format("Value units: found '{}', but must be one of {}",
                            printable(line.text), known_length_units()));
  return *metres;
}

/// What a text matrix says of its map.
struct TextMatrix {
  Grid grid;
  std::string channel; ///< may be empty
  std::string reader;
  FileNumbers numbers;
};

TextMatrix gwyddion_matrix(const NumberTable& table, const Grid& points,
                           const MapScale& scale) {
  const GwyddionHeader header = gwyddion_header(table);
  Grid grid = points;
  grid.length_x = header_length(table, header.width, "Width");
  grid.length_y = header_length(table, header.height, "Height");
  for (const auto& [key, value] : {std::pair("length", scale.length),
                                   std::pair("length_y", scale.length_y),
                                   std::pair("length_unit", scale.length_unit)})
    refuse_given(key, value,
                 fmt::format("line {} of {} gives '{}'", header.width.line,
                             table.name, printable(header.width.text)));
  return {grid,
          header.channel.text,
          "own reader of Gwyddion text",
          {.unit = header_height_unit(table, header.value_units, scale)}};
}

TextMatrix plain_matrix(const NumberTable& table, const Grid& points,
                        MapScale scale, const std::string& format) {
  MatrixHeader header = matrix_header(table);
  const auto take = [&](std::optional<double>& given, const char* key,
                        const std::optional<double>& found) {
    if (!found)
      return;
    refuse_given(key, given,
                 fmt::format("the header of {} gives it", table.name));
    given = found;
  };
  if (header.cell_size) {
    if (!scale.length_unit)
      throw input::InputError(fmt::format(
          "surface.length_unit is missing: the header of {} gives cellsize = "
          "{:.6g} without a unit",
          table.name, *header.cell_size));
    require_positive("length_unit", *scale.length_unit, "m");
    const double cell = *header.cell_size * *scale.length_unit;
    header.length_x = cell * points.points_x;
    header.length_y = cell * points.points_y;
  } else {
    refuse_given("length_unit", scale.length_unit,
                 table.name + " is a matrix, and only a list x y z has columns "
                              "x and y");
  }
  take(scale.length, "length", header.length_x);
  take(scale.length_y, "length_y", header.length_y);
  take(scale.height_unit, "height_unit", header.height_unit);
  if (format != "plain") {
    const double x = scale.length.value_or(0.0);
    const double y =
        scale.length_y.value_or(x * points.points_y / points.points_x);
    require_understood(header.not_understood, table.name,
                       {x, y, x / points.points_x, y / points.points_y},
                       {scale.height_unit.value_or(0.0)});
  }
  const Grid grid = grid_by_scale(points, table.name, "a plain matrix", scale);
  require_sound_lengths(table.name, grid);
  return {grid,
          "",
          "own reader of plain matrices",
          {.unit = *scale.height_unit, .missing = header.missing_value}};
}

bool is_gwyddion(const NumberTable& table, const std::string& format) {
  return format == "gwyddion" ||
         (format == "auto" && gwyddion_header(table).width.line != 0);
}

TextMatrix text_matrix(const NumberTable& table, const ScanRequest& request) {
  if (table.columns < 2 || table.rows() < 2)
    throw input::InputError(fmt::format("{}: {} column(s) and {} row(s), but a "
                                        "map must have at least two of each",
                                        table.name, table.columns,
                                        table.rows()));
  Grid points;
  points.points_x = static_cast<int>(table.columns);
  points.points_y = static_cast<int>(table.rows());
  return is_gwyddion(table, request.format)
             ? gwyddion_matrix(table, points, request.scale)
             : plain_matrix(table, points, request.scale, request.format);
}

Scan scan_of_table(NumberTable table, const ScanRequest& request) {
  const bool is_plain =
      request.format == "auto" && !is_gwyddion(table, request.format);
  if (request.format == "xyz" || (is_plain && is_regular_list(table))) {
    if (is_plain)
      require_list_header(table, request.scale);
    return scan_of_list(table, request.scale);
  }
  if (is_plain)
    if (std::optional<Scan> scan = fourier_scan(table, request.scale))
      return std::move(*scan);
  if (is_plain)
    refuse_possible_list(table.name, table.columns, table.rows());
  const TextMatrix matrix = text_matrix(table, request);
  Scan scan = scan_of_numbers(matrix.grid, std::move(table.numbers),
                              matrix.reader, matrix.numbers);
  scan.channel = matrix.channel;
  return scan;
}

Scan read_text(const MapBytes& bytes, const ScanRequest& request) {
  Scan scan = scan_of_table(
      read_number_text(bytes.all(), bytes.name(), NumberStyle::instrument),
      request);
  refuse_channel(request, scan.channel, bytes.name());
  return scan;
}

std::vector<ChannelInfo> text_channels(const MapBytes& bytes) {
  const NumberTable table =
      read_number_text(bytes.all(), bytes.name(), NumberStyle::instrument);
  const GwyddionHeader header = gwyddion_header(table);
  const bool is_plain = header.width.line == 0;
  if (is_plain && is_regular_list(table)) {
    const Grid grid = scan_of_list(table, {{}, 1.0, {}, 1.0}).map.grid;
    return {{"", "", grid.points_x, grid.points_y}};
  }
  if (const int points = is_plain ? fourier_points(table) : 0; points > 0)
    return {{"", "", points, points}};
  return {{header.channel.text, header.value_units.text,
           static_cast<int>(table.columns), static_cast<int>(table.rows())}};
}

/// A format of texts, which is recognised as text first.
MapFormat text_format(const char* name, FormatWords words, FileScales scales) {
  return {.name = name,
          .words = std::move(words),
          .reads = [](std::string_view) { return false; },
          .heights = read_text,
          .channels = text_channels,
          .scales = scales};
}

} // namespace

MapFormat gwyddion_format() {
  return text_format("gwyddion",
                     {"Gwyddion text matrix", "header with width and height",
                      "header; [units of length](case.md#units)", "words",
                      "one"},
                     FileScales::lengths);
}

MapFormat plain_format() {
  return text_format("plain",
                     {"text matrix", "numbers",
                      "`length`, `height_unit`, unless the header gives them; "
                      "square pixels unless `length_y` is given",
                      "words, empty cells; the number that the header names",
                      "one"},
                     FileScales::none);
}

MapFormat xyz_format() {
  return text_format("xyz",
                     {"list x y z", "three columns on a regular grid",
                      "`length_unit` for x and y, `height_unit` for z",
                      "words, empty cells, and points that are not in the list",
                      "one"},
                     FileScales::some);
}

MapFormat other_text_format() {
  MapFormat format = text_format(
      "",
      {"Fourier coefficients qX qY Re Im",
       "four columns, whole numbers in the first two, conjugates for q and -q",
       "`length` is the period in both directions, `height_unit` that of the "
       "coefficients",
       "none", "one"},
      FileScales::some);
  format.reads = is_text_map;
  return format;
}

} // namespace asperity::surfaces
