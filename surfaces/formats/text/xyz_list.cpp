#include "surfaces/formats/text/xyz_list.hpp"

#include "base/require.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/own_readers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace asperity::surfaces {
namespace {

std::size_t index_of(const ListGrid& grid, const NumberTable& table,
                     std::size_t row) {
  return grid.y.index_of(table.number(row, 1)) * grid.x.points +
         grid.x.index_of(table.number(row, 0));
}

std::optional<ListGrid> grid_of(const NumberTable& table) {
  return grid_of_axes(axis_of(table, 0), axis_of(table, 1), table.rows());
}

/// The positions in ascending order.
std::vector<ListPositions> ascending(std::vector<ListPositions> points) {
  if (!points.empty() && points.back().least < points.front().least)
    std::ranges::reverse(points);
  return points;
}

} // namespace

bool ListAxis::is_regular(double position) const {
  const double allowed =
      std::clamp(2.0 * rounding, 0.02 * spacing, 0.25 * spacing);
  return std::abs(position - first -
                  std::round((position - first) / spacing) * spacing) <=
         allowed;
}

std::optional<ListAxis> axis_of(const NumberTable& table, std::size_t column) {
  std::vector<double> positions(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row)
    positions[row] = table.number(row, column);
  if (!std::all_of(positions.begin(), positions.end(),
                   [](double x) { return std::isfinite(x); }))
    return std::nullopt;
  std::sort(positions.begin(), positions.end());
  const double extent = positions.back() - positions.front();
  if (!std::isfinite(extent) || extent <= 0.0)
    return std::nullopt;
  // Gaps between sorted positions are spacings or rounding.
  double largest_gap = 0.0;
  for (std::size_t i = 1; i < positions.size(); ++i)
    largest_gap = std::max(largest_gap, positions[i] - positions[i - 1]);
  std::size_t count = 1;
  for (std::size_t i = 1; i < positions.size(); ++i)
    if (positions[i] - positions[i - 1] > 0.5 * largest_gap)
      ++count;
  const ListAxis axis{positions.front(),
                      extent / static_cast<double>(count - 1), count,
                      table.digits.at(column).rounding()};
  for (const double position : positions)
    if (!axis.is_regular(position))
      return std::nullopt;
  return axis;
}

std::optional<ListAxis> axis_of(const std::vector<ListPositions>& points,
                                double rounding) {
  double largest_gap = 0.0, largest_rounding = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
    largest_gap =
        std::max(largest_gap, points[i].least - points[i - 1].largest);
  for (const ListPositions& point : points)
    largest_rounding = std::max(largest_rounding, point.largest - point.least);
  const double extent = points.back().largest - points.front().least;
  if (points.size() < 2 || !std::isfinite(extent) ||
      !(largest_rounding <= 0.5 * largest_gap))
    return std::nullopt;
  const ListAxis axis{points.front().least,
                      extent / static_cast<double>(points.size() - 1),
                      points.size(), rounding};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_apart =
        i == 0 || points[i].least - points[i - 1].largest > 0.5 * largest_gap;
    for (const double position : {points[i].least, points[i].largest})
      if (!is_apart || !axis.is_regular(position) ||
          axis.index_of(position) != i)
        return std::nullopt;
  }
  return axis;
}

std::optional<ListGrid> grid_of_axes(const std::optional<ListAxis>& x,
                                     const std::optional<ListAxis>& y,
                                     std::size_t n_points) {
  constexpr std::size_t most = 1 << 20;
  if (!x || !y || x->points > most || y->points > most ||
      x->points * y->points > 2 * n_points)
    return std::nullopt;
  return ListGrid{*x, *y};
}

Grid ListGrid::scaled(const std::string& name, const MapScale& scale) const {
  if (!scale.length_unit || !scale.height_unit)
    throw input::InputError(fmt::format(
        "surface.{} is missing: {} is a list x y z, which does not give the "
        "unit of {}",
        scale.length_unit ? "height_unit" : "length_unit", name,
        scale.length_unit ? "z" : "x and y"));
  refuse_scale({scale.length, {}, scale.length_y, {}}, name);
  require_positive("length_unit", *scale.length_unit, "m");
  require_positive("height_unit", *scale.height_unit, "m");
  const Grid grid{
      static_cast<int>(x.points), static_cast<int>(y.points),
      static_cast<double>(x.points) * x.spacing * *scale.length_unit,
      static_cast<double>(y.points) * y.spacing * *scale.length_unit};
  require_sound_lengths(name, grid);
  return grid;
}

bool may_be_list(const NumberTable& table) {
  return table.columns == 3 && table.rows() >= 4;
}

bool is_regular_list(const NumberTable& table) {
  if (!may_be_list(table))
    return false;
  const auto grid = grid_of(table);
  if (!grid || table.rows() > grid->x.points * grid->y.points)
    return false;
  std::vector<bool> is_there(grid->x.points * grid->y.points, false);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t index = index_of(*grid, table, row);
    if (is_there[index])
      return false;
    is_there[index] = true;
  }
  return true;
}

void refuse_possible_list(const std::string& name, std::size_t columns,
                          std::size_t rows) {
  if (columns == list_columns && rows >= 4)
    throw input::InputError(fmt::format(
        "{}: {} rows of 3 columns may be a list x y z, whose positions are not "
        "the points of a regular grid, or a matrix; format = \"plain\" reads "
        "a matrix with three columns, and a list must be interpolated first",
        name, rows));
  if (columns == 2 && rows >= 4)
    throw input::InputError(fmt::format(
        "{}: {} rows of 2 columns are probably a line scan x z, which is no "
        "map; format = \"plain\" reads a matrix with two columns",
        name, rows));
}

void refuse_irregular_list(const std::string& name) {
  throw input::InputError(fmt::format(
      "{}: the positions x and y of the list are not the points of a regular "
      "grid; interpolate the heights on one first",
      name));
}

void refuse_repeated_point(const std::string& name, int line, int first) {
  refuse_line(name, line,
              fmt::format("the point of line {} again: each point of the grid "
                          "may occur once",
                          first));
}

void require_list_columns(const NumberTable& table) {
  if (table.columns != list_columns)
    throw input::InputError(fmt::format(
        "{}: {} columns, but a list x y z has 3", table.name, table.columns));
}

Scan scan_of_list(const NumberTable& table, const MapScale& scale) {
  require_list_columns(table);
  const auto grid = grid_of(table);
  if (!grid)
    refuse_irregular_list(table.name);
  Scan scan;
  scan.map.grid = grid->scaled(table.name, scale);
  scan.map.heights.assign(scan.map.grid.size(),
                          std::numeric_limits<double>::quiet_NaN());
  std::vector<int> lines(scan.map.grid.size(), 0);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t index = index_of(*grid, table, row);
    if (lines[index] != 0)
      refuse_repeated_point(table.name, table.lines[row], lines[index]);
    lines[index] = table.lines[row];
    scan.map.heights[index] = table.number(row, 2) * *scale.height_unit;
  }
  mark_missing(scan, table.name);
  scan.numbers.unit = *scale.height_unit;
  scan.reader = list_reader;
  return scan;
}

bool ListOrder::take(double x, double y, std::uint64_t begin, int line) {
  constexpr std::size_t most = 1 << 20;
  if (!std::isfinite(x) || !std::isfinite(y))
    return false;
  const bool is_first_row = rows_.size() <= 1;
  if (rows_.empty() ||
      (is_first_row ? x < columns_.back().least : in_row_ == columns_.size())) {
    rows_.push_back({y, y});
    begins_.push_back({begin, line});
    in_row_ = 0;
  }
  if (rows_.size() == 1)
    columns_.push_back({x, x});
  ListPositions& column = columns_[in_row_++];
  ListPositions& row = rows_.back();
  column = {std::min(column.least, x), std::max(column.largest, x)};
  row = {std::min(row.least, y), std::max(row.largest, y)};
  return columns_.size() <= most && rows_.size() <= most;
}

bool ListOrder::is_grid() const {
  return columns_.size() > 1 && rows_.size() > 1 &&
         in_row_ == columns_.size() && axis_of(columns_, rounding_[0]) &&
         axis_of(ascending(rows_), rounding_[1]);
}

Grid ListOrder::grid(const std::string& name, const MapScale& scale) const {
  return ListGrid{*axis_of(columns_, rounding_[0]),
                  *axis_of(ascending(rows_), rounding_[1])}
      .scaled(name, scale);
}

const ListOrder::Row& ListOrder::row(int y) const {
  const auto at = static_cast<std::size_t>(y);
  return begins_[is_reversed() ? begins_.size() - 1 - at : at];
}

} // namespace asperity::surfaces
