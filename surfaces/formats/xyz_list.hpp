#pragma once

// This file recognises a list of points x y z on a regular grid and makes a map
// of it, so that no list is ever taken for a matrix with three columns.

#include "surfaces/formats/number_table.hpp"
#include "surfaces/formats/scan.hpp"

namespace asperity::surfaces {

/// Whether a table may be a list: three columns and at least four rows.
bool may_be_list(const NumberTable& table);

/// Whether the first two columns are the points of a regular grid. The
/// positions of an axis must be equidistant within 2 % of their spacing, no
/// point may occur twice, and at least half of the grid must be present.
bool is_regular_list(const NumberTable& table);

/// Refuses what may be a list, but whose positions are not regular, and what
/// may be a line scan (four or more rows of two columns): it must not be taken
/// for a matrix unless the case says so.
/// @throws input::InputError  as described
void refuse_possible_list(const NumberTable& table);

/// The map of a list: x along rows and y along columns, both ascending, with
/// period points * spacing along each side. Points that are not in the list are
/// missing.
/// @param scale  length_unit (columns x and y) and height_unit (column z) are
///               needed, the others must be empty
/// @throws input::InputError  with name:line, or the key of the case
Scan scan_of_list(const NumberTable& table, const MapScale& scale);

} // namespace asperity::surfaces
