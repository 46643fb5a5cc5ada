#pragma once

// Recognises a list of points x y z on a regular grid and makes a map of it, so
// that no list is ever taken for a matrix with three columns.

#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity::surfaces {

/// Whether a table may be a list: three columns and at least four rows.
bool may_be_list(const NumberTable& table);

/// Whether the first two columns are the points of a regular grid. The
/// positions of an axis must be equidistant within 2 % of their spacing, or
/// within the rounding of their last printed digit if that is larger, no point
/// may occur twice, and at least half of the grid must be present.
bool is_regular_list(const NumberTable& table);

/// Refuses what may be a list, but whose positions are not regular, and what
/// may be a line scan (four or more rows of two columns): it must not be taken
/// for a matrix unless the case says so.
/// @throws input::InputError  as described
void refuse_possible_list(const std::string& name, std::size_t columns,
                          std::size_t rows);

/// @throws input::InputError  a list has another number of columns
void require_list_columns(const NumberTable& table);

/// Refuses a list whose positions are not the points of a regular grid.
/// @throws input::InputError  always
[[noreturn]] void refuse_irregular_list(const std::string& name);

/// Refuses a list with a point twice.
/// @param line   of the point that is there again
/// @param first  its first line
/// @throws input::InputError  always
[[noreturn]] void refuse_repeated_point(const std::string& name, int line,
                                        int first);

/// The map of a list: x along rows and y along columns, both ascending, with
/// period points * spacing along each side. Points that are not in the list are
/// missing.
/// @param scale  length_unit (columns x and y) and height_unit (column z) are
///               needed, the others must be empty
/// @throws input::InputError  with name:line, or the key of the case
Scan scan_of_list(const NumberTable& table, const MapScale& scale);

/// Columns of a list.
inline constexpr std::size_t list_columns = 3;

inline constexpr const char* list_reader = "own reader of lists x y z";

/// Positions of the points of one column or row of a list, which differ by the
/// rounding of the file.
struct ListPositions {
  double least = 0.0, largest = 0.0;
};

/// Equidistant positions first + i spacing.
struct ListAxis {
  double first = 0.0;
  double spacing = 0.0;
  std::size_t points = 0;
  double rounding = 0.0; ///< error of a printed position

  std::size_t index_of(double position) const {
    return std::min(
        static_cast<std::size_t>(std::lround((position - first) / spacing)),
        points - 1);
  }

  /// Whether a position is that of its point but for rounding: within 2 % of
  /// the spacing, or within the errors of two printed positions up to a quarter
  /// of it, beyond which a point could be that of another place.
  bool is_regular(double position) const;

  /// Whether it is that of a point of the axis.
  bool has(double position) const {
    const double at = std::round((position - first) / spacing);
    return is_regular(position) && at >= 0.0 &&
           at < static_cast<double>(points);
  }
};

/// Axes of the grid of a list.
struct ListGrid {
  ListAxis x, y;

  /// @throws input::InputError  as scan_of_list(), about the scales
  Grid scaled(const std::string& name, const MapScale& scale) const;
};

/// The axis that scan_of_list() finds.
/// @param points    positions of its points in ascending order
/// @param rounding  error of a printed position
/// @return  empty if the points are not equidistant
std::optional<ListAxis> axis_of(const std::vector<ListPositions>& points,
                                double rounding);

/// The axis of a column, in any order.
std::optional<ListAxis> axis_of(const NumberTable& table, std::size_t column);

/// The axes, if they can be those of a list.
/// @param n_points  of the list, which must be at least half of the grid
std::optional<ListGrid> grid_of_axes(const std::optional<ListAxis>& x,
                                     const std::optional<ListAxis>& y,
                                     std::size_t n_points);

/// Examines the points of a list one after the other and keeps only the sides
/// of its grid.
class ListOrder {
public:
  /// Takes the next point.
  /// @param begin  first byte of its line
  /// @param line   its number, from 1
  /// @return  whether the points so far are in the order of a grid: x grows
  ///          within a row, and all rows have the same number of points
  bool take(double x, double y, std::uint64_t begin, int line);

  /// Takes the errors of the printed positions x and y, of the whole file.
  void set_rounding(const std::array<double, 2>& rounding) {
    rounding_ = rounding;
  }

  /// Whether the list is that of a complete grid, whose rows are in the order
  /// of y or in the opposite order. The grid is then that of scan_of_list().
  bool is_grid() const;

  /// @throws input::InputError  as scan_of_list(), about the scales
  Grid grid(const std::string& name, const MapScale& scale) const;

  /// Where a row of the grid is in the file.
  struct Row {
    std::uint64_t begin = 0; ///< first byte of its first line
    int line = 0;            ///< number of that line
  };

  const Row& row(int y) const;

  /// Whether the file begins with the last row of the grid.
  bool is_reversed() const { return rows_.back().least < rows_.front().least; }

  /// Points of a row.
  std::size_t columns() const { return columns_.size(); }

private:
  std::vector<ListPositions> columns_, rows_; ///< in the order of the file
  std::vector<Row> begins_;                   ///< of the rows
  std::size_t in_row_ = 0;                    ///< points of the last row so far
  std::array<double, 2> rounding_ = {};
};

} // namespace asperity::surfaces
