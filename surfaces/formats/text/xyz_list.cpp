#include "surfaces/formats/text/xyz_list.hpp"

#include "base/require.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/map_format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace asperity::surfaces {
namespace {

constexpr std::size_t list_columns = 3;

/// Axes of the grid of a list.
struct ListGrid {
  ListAxis x, y;

  std::size_t size() const { return x.points * y.points; }

  std::size_t index_of(const NumberTable& table, std::size_t row) const {
    return y.index_of(table.number(row, 1)) * x.points +
           x.index_of(table.number(row, 0));
  }
};

/// The axes, if they can be those of a list, which has at least half of the
/// points of the grid.
std::optional<ListGrid> grid_of_list(const NumberTable& table) {
  constexpr std::size_t most = 1 << 20;
  const auto x = axis_of(table, 0), y = axis_of(table, 1);
  if (!x || !y || x->points > most || y->points > most ||
      x->points * y->points > 2 * table.rows())
    return std::nullopt;
  return ListGrid{*x, *y};
}

Grid scaled_grid(const ListGrid& list, const std::string& name,
                 const MapScale& scale) {
  if (!scale.length_unit || !scale.height_unit)
    throw input::InputError(fmt::format(
        "surface.{} is missing: {} is a list x y z, which does not give the "
        "unit of {}",
        scale.length_unit ? "height_unit" : "length_unit", name,
        scale.length_unit ? "z" : "x and y"));
  refuse_scale({scale.length, {}, scale.length_y, {}}, name);
  require_positive("length_unit", *scale.length_unit, "m");
  require_positive("height_unit", *scale.height_unit, "m");
  const auto side = [&](const ListAxis& axis) {
    return static_cast<double>(axis.points) * axis.spacing * *scale.length_unit;
  };
  const Grid grid{static_cast<int>(list.x.points),
                  static_cast<int>(list.y.points), side(list.x), side(list.y)};
  require_sound_lengths(name, grid);
  return grid;
}

} // namespace

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
                      extent / static_cast<double>(count - 1), count};
  const double spacing = axis.spacing;
  const double allowed = std::clamp(2.0 * table.digits.at(column).rounding(),
                                    0.02 * spacing, 0.25 * spacing);
  for (const double position : positions)
    if (!(std::abs(position - axis.first -
                   std::round((position - axis.first) / spacing) * spacing) <=
          allowed))
      return std::nullopt;
  return axis;
}

bool is_regular_list(const NumberTable& table) {
  if (table.columns != list_columns || table.rows() < 4)
    return false;
  const auto grid = grid_of_list(table);
  if (!grid || table.rows() > grid->size())
    return false;
  std::vector<bool> is_there(grid->size(), false);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t index = grid->index_of(table, row);
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

Scan scan_of_list(const NumberTable& table, const MapScale& scale) {
  if (table.columns != list_columns)
    throw input::InputError(fmt::format(
        "{}: {} columns, but a list x y z has 3", table.name, table.columns));
  const auto list = grid_of_list(table);
  if (!list)
    throw input::InputError(fmt::format(
        "{}: the positions x and y of the list are not the points of a regular "
        "grid; interpolate the heights on one first",
        table.name));
  const Grid grid = scaled_grid(*list, table.name, scale);
  std::vector<double> values(grid.size(),
                             std::numeric_limits<double>::quiet_NaN());
  std::vector<int> lines(grid.size(), 0);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t index = list->index_of(table, row);
    if (lines[index] != 0)
      refuse_line(table.name, table.lines[row],
                  fmt::format("the point of line {} again: each point of the "
                              "grid may occur once",
                              lines[index]));
    lines[index] = table.lines[row];
    values[index] = table.number(row, 2);
  }
  return scan_of_numbers(grid, std::move(values), "own reader of lists x y z",
                         {.unit = *scale.height_unit});
}

} // namespace asperity::surfaces
