#pragma once

// Recognises a list of points x y z on a regular grid and makes a map of it, so
// that no list is ever taken for a matrix with three columns.

#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace asperity::surfaces {

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

/// The map of a list: x along rows and y along columns, both ascending, with
/// period points * spacing along each side. Points that are not in the list are
/// missing.
/// @param scale  length_unit (columns x and y) and height_unit (column z) are
///               needed, the others must be empty
/// @throws input::InputError  with name:line, or the key of the case
Scan scan_of_list(const NumberTable& table, const MapScale& scale);

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

/// The axis of a column, whose positions are in any order. They must be
/// equidistant within 2 % of the spacing, or within the errors of two printed
/// positions up to a quarter of it, beyond which a point could be that of
/// another place.
/// @return  empty if they are not
std::optional<ListAxis> axis_of(const NumberTable& table, std::size_t column);

} // namespace asperity::surfaces
