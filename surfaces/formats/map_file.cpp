#include "surfaces/formats/map_file.hpp"

#include "base/plain_text.hpp"
#include "base/require.hpp"
#include "cases/text/case_error.hpp"
#include "surfaces/formats/number_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

namespace asperity::surfaces {
namespace {

constexpr const char* known_units = "m, mm, um, nm, pm, angstrom";

/// Metres per unit; empty if the unit is not a length.
std::optional<double> length_unit(std::string_view unit) {
  static constexpr std::pair<std::string_view, double> units[] = {
      {"m", 1.0},
      {"mm", 1e-3},
      {"um", 1e-6},
      {"\xC2\xB5m", 1e-6}, // micro sign, UTF-8
      {"\xCE\xBCm", 1e-6}, // Greek mu, UTF-8
      {"\xB5m", 1e-6},     // micro sign, Latin-1
      {"nm", 1e-9},
      {"pm", 1e-12},
      {"angstrom", 1e-10},
      {"\xC3\x85", 1e-10},     // A with ring, UTF-8
      {"\xE2\x84\xAB", 1e-10}, // Angstrom sign, UTF-8
      {"\xC5", 1e-10},         // A with ring, Latin-1
  };
  for (const auto& [name, metres] : units)
    if (unit == name)
      return metres;
  return std::nullopt;
}

/// The header line "<key>: <content>"; its line number is 0 if there is none.
CommentLine header(const NumberTable& table, std::string_view key) {
  for (const CommentLine& comment : table.comments) {
    const std::string_view text = comment.text;
    if (text.substr(0, key.size()) != key || text.substr(key.size(), 1) != ":")
      continue;
    const std::size_t content = text.find_first_not_of(" \t", key.size() + 1);
    return {comment.line, content == std::string_view::npos
                              ? std::string()
                              : std::string(text.substr(content))};
  }
  return {};
}

/// Converts the header line of `key`, such as "20.0 um", to metres.
double header_length(const NumberTable& table, const char* key) {
  const CommentLine line = header(table, key);
  if (line.line == 0)
    throw cases::CaseError(fmt::format(
        "{}: no line '# {}: 20 um', which a Gwyddion text matrix begins with",
        table.name, key));
  const std::string& text = line.text;
  double number = 0.0;
  const auto [stop, error] =
      std::from_chars(text.data(), text.data() + text.size(), number);
  std::string_view unit(
      stop, static_cast<std::size_t>(text.data() + text.size() - stop));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  const std::optional<double> metres = length_unit(unit);
  if (error != std::errc{} || !metres || !std::isfinite(number) ||
      number <= 0.0)
    refuse_line(table.name, line.line,
                fmt::format("{}: found '{}', but must be a number > 0 and a "
                            "unit of {}",
                            key, printable(text), known_units));
  return number * *metres;
}

double header_height_unit(const NumberTable& table, const MapScale& scale) {
  const CommentLine line = header(table, "Value units");
  if (line.line == 0) {
    if (!scale.height_unit)
      throw cases::CaseError(fmt::format(
          "surface.height_unit is missing: {} has no line '# Value units: m'",
          table.name));
    return *scale.height_unit;
  }
  if (scale.height_unit)
    throw cases::CaseError(fmt::format(
        "surface.height_unit = {:.6g} m, but must be left out: line {} of {} "
        "gives '{}'",
        *scale.height_unit, line.line, table.name, printable(line.text)));
  const std::optional<double> metres = length_unit(line.text);
  if (!metres)
    refuse_line(table.name, line.line,
                fmt::format("Value units: found '{}', but must be one of {}",
                            printable(line.text), known_units));
  return *metres;
}

HeightMap from_gwyddion(NumberTable table, const Grid& points,
                        const MapScale& scale) {
  Grid grid = points;
  grid.length_x = header_length(table, "Width");
  grid.length_y = header_length(table, "Height");
  if (scale.length)
    throw cases::CaseError(fmt::format("surface.length = {:.6g} m, but must be "
                                       "left out: line {} of {} gives '{}'",
                                       *scale.length,
                                       header(table, "Width").line, table.name,
                                       printable(header(table, "Width").text)));
  const double unit = header_height_unit(table, scale);
  for (double& height : table.numbers)
    height *= unit;
  return {grid, std::move(table.numbers)};
}

HeightMap from_plain(NumberTable table, const Grid& points,
                     const MapScale& scale) {
  if (!scale.length)
    throw cases::CaseError(
        fmt::format("surface.length is missing: {} is a plain matrix, which "
                    "does not give its width",
                    table.name));
  if (!scale.height_unit)
    throw cases::CaseError(
        fmt::format("surface.height_unit is missing: {} is a plain matrix, "
                    "which does not give the unit of its heights",
                    table.name));
  require_positive("length", *scale.length, "m");
  Grid grid = points;
  grid.length_x = *scale.length;
  grid.length_y = *scale.length * grid.points_y / grid.points_x;
  const double unit = *scale.height_unit;
  require_positive("height_unit", unit, "m");
  for (double& height : table.numbers)
    height *= unit;
  return {grid, std::move(table.numbers)};
}

HeightMap from_table(NumberTable table, cases::MapFormat format,
                     const MapScale& scale) {
  if (table.columns < 2 || table.rows() < 2)
    throw cases::CaseError(fmt::format("{}: {} column(s) and {} row(s), but a "
                                       "map must have at least two of each",
                                       table.name, table.columns,
                                       table.rows()));
  Grid points;
  points.points_x = static_cast<int>(table.columns);
  points.points_y = static_cast<int>(table.rows());
  const bool is_gwyddion =
      format == cases::MapFormat::gwyddion ||
      (format == cases::MapFormat::automatic && header(table, "Width").line);
  return is_gwyddion ? from_gwyddion(std::move(table), points, scale)
                     : from_plain(std::move(table), points, scale);
}

} // namespace

HeightMap read_height_map_text(std::string_view text, const std::string& name,
                               cases::MapFormat format, const MapScale& scale) {
  return from_table(read_number_text(text, name), format, scale);
}

HeightMap read_height_map(const std::string& path, cases::MapFormat format,
                          const MapScale& scale) {
  return read_scan(path, {format, {}, scale}).map;
}

} // namespace asperity::surfaces
