#include "surfaces/formats/xyz_list.hpp"

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

/// Equidistant positions first + i spacing.
struct ListAxis {
  double first = 0.0;
  double spacing = 0.0;
  std::size_t points = 0;

  std::size_t index_of(double position) const {
    return std::min(
        static_cast<std::size_t>(std::lround((position - first) / spacing)),
        points - 1);
  }
};

/// Returns the axis of a column; empty if its positions are not equidistant.
std::optional<ListAxis> axis_of(const NumberTable& table, std::size_t column) {
  constexpr double regular = 0.02; // of the spacing: rounding of the file
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
                      extent / static_cast<double>(count - 1), count};
  for (const double position : positions)
    if (std::abs(position - axis.first -
                 std::round((position - axis.first) / axis.spacing) *
                     axis.spacing) > regular * axis.spacing)
      return std::nullopt;
  return axis;
}

struct ListGrid {
  ListAxis x;
  ListAxis y;

  std::size_t index_of(const NumberTable& table, std::size_t row) const {
    return y.index_of(table.number(row, 1)) * x.points +
           x.index_of(table.number(row, 0));
  }
};

/// Returns the grid if at least half of its points may be in the list.
std::optional<ListGrid> grid_of(const NumberTable& table) {
  const auto x = axis_of(table, 0);
  const auto y = axis_of(table, 1);
  constexpr std::size_t most = 1 << 20;
  if (!x || !y || x->points > most || y->points > most ||
      x->points * y->points > 2 * table.rows())
    return std::nullopt;
  return ListGrid{*x, *y};
}

} // namespace

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
    const std::size_t index = grid->index_of(table, row);
    if (is_there[index])
      return false;
    is_there[index] = true;
  }
  return true;
}

void refuse_possible_list(const NumberTable& table) {
  if (may_be_list(table))
    throw input::InputError(fmt::format(
        "{}: {} rows of 3 columns may be a list x y z, whose positions are not "
        "the points of a regular grid, or a matrix; format = \"plain\" reads "
        "a matrix with three columns, and a list must be interpolated first",
        table.name, table.rows()));
  if (table.columns == 2 && table.rows() >= 4)
    throw input::InputError(fmt::format(
        "{}: {} rows of 2 columns are probably a line scan x z, which is no "
        "map; format = \"plain\" reads a matrix with two columns",
        table.name, table.rows()));
}

Scan scan_of_list(const NumberTable& table, const MapScale& scale) {
  if (table.columns != 3)
    throw input::InputError(fmt::format(
        "{}: {} columns, but a list x y z has 3", table.name, table.columns));
  const auto grid = grid_of(table);
  if (!grid)
    throw input::InputError(fmt::format(
        "{}: the positions x and y of the list are not the points of a regular "
        "grid; interpolate the heights on one first",
        table.name));
  if (!scale.length_unit || !scale.height_unit)
    throw input::InputError(fmt::format(
        "surface.{} is missing: {} is a list x y z, which does not give the "
        "unit of {}",
        scale.length_unit ? "height_unit" : "length_unit", table.name,
        scale.length_unit ? "z" : "x and y"));
  refuse_scale({scale.length, {}, scale.length_y, {}}, table.name);
  require_positive("length_unit", *scale.length_unit, "m");
  require_positive("height_unit", *scale.height_unit, "m");
  const auto& [x, y] = *grid;
  Scan scan;
  scan.map.grid = {
      static_cast<int>(x.points), static_cast<int>(y.points),
      static_cast<double>(x.points) * x.spacing * *scale.length_unit,
      static_cast<double>(y.points) * y.spacing * *scale.length_unit};
  require_sound_lengths(table.name, scan.map.grid);
  scan.map.heights.assign(scan.map.grid.size(),
                          std::numeric_limits<double>::quiet_NaN());
  std::vector<int> lines(scan.map.grid.size(), 0);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t index = grid->index_of(table, row);
    if (lines[index] != 0)
      refuse_line(table.name, table.lines[row],
                  fmt::format("the point of line {} again: each point of the "
                              "grid may occur once",
                              lines[index]));
    lines[index] = table.lines[row];
    scan.map.heights[index] = table.number(row, 2) * *scale.height_unit;
  }
  mark_missing(scan, table.name);
  scan.reader = "own reader of lists x y z";
  return scan;
}

} // namespace asperity::surfaces
