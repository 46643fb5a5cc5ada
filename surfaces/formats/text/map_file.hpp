#pragma once

// Reads measured height maps from text files in the formats written by Gwyddion
// and by scripts, including headers, length units and the orientation of a
// matrix.

#include "surfaces/formats/scan.hpp"

#include <string>
#include <string_view>

namespace asperity::surfaces {

/// Reads a text matrix of heights, or a list x y z, without levelling it or
/// removing its mean. Columns go along x, rows along y, starting with the first
/// line; a map may be rectangular and have an odd number of points. The numbers
/// are read as in read_number_text, in the style of instruments.
///
/// Gwyddion's text matrix begins with the lines
///
///     # Channel: Topography     title; may be absent
///     # Width: 20.0 um          period in x, number and length unit
///     # Height: 20.0 um         period in y
///     # Value units: nm         of the numbers
///
/// in English or in another language (text_header.hpp), with the units of
/// length_unit, which may differ between the lines. Then the lengths of `scale`
/// must be empty, and scale.height_unit as well unless the file has no value
/// units.
///
/// Any other file is a plain matrix, for which scale.length is the period in x,
/// pixels are square unless scale.length_y is given, and scale.height_unit is
/// the unit of its numbers, unless a header gives them (text_header.hpp); or a
/// list x y z on a regular grid (xyz_list.hpp), which needs scale.length_unit
/// and scale.height_unit.
///
/// @param format  automatic: Gwyddion if a comment contains a width; a list if
///                three columns are the points of a regular grid; three columns
///                and four or more rows that are no such grid are refused
/// @throws input::InputError  with name:line of the error in the file, or the
///                            key of the case that is missing or superfluous,
///                            or the number of missing points
HeightMap read_height_map_text(std::string_view text, const std::string& name,
                               mechanics::MapFormat format,
                               const MapScale& scale);

} // namespace asperity::surfaces
