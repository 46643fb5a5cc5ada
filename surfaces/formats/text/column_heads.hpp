#pragma once

// The names and units of the columns in the header line of a table of numbers.

#include "surfaces/formats/text/number_table.hpp"

#include <string>
#include <vector>

namespace asperity::surfaces {

struct ColumnHead {
  std::string name; ///< in lower case
  std::string unit; ///< as the file has it; empty: the head has none
};

/// Reads a header line, whose cells may be in quotes and are separated by
/// semicolons, tabs or commas, else follow a bracket or two blanks, else, if
/// that gives as many cells as there are columns, single blanks. A unit is in
/// brackets, "pressure [MPa]" and "pressure (MPa)", or is a unit of the table
/// of units behind a stroke, a comma, an underscore or a blank: "pressure /
/// MPa", "pressure_MPa" and "pressure in MPa".
std::vector<ColumnHead> column_heads(const std::string& line,
                                     std::size_t columns);

/// The header lines in front of the numbers of a table, the last one first.
std::vector<CommentLine> lines_above_numbers(const NumberTable& table);

} // namespace asperity::surfaces
