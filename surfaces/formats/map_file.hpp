#pragma once

// This file reads measured height maps from text files in the formats written
// by Gwyddion and by scripts, including headers, length units and the
// orientation of a matrix.

#include "surfaces/formats/scan.hpp"

#include <string>
#include <string_view>

namespace asperity::surfaces {

/// Reads a matrix of heights without levelling it or removing its mean. Columns
/// go along x, rows along y, starting with the first line; a map may be
/// rectangular and have an odd number of points. The numbers are read as in
/// read_number_text.
///
/// Gwyddion's text matrix begins with the lines
///
///     # Width: 20.0 um          period in x, number and length unit
///     # Height: 20.0 um         period in y
///     # Value units: nm         of the numbers
///
/// with the units m, mm, um, nm, pm or angstrom (or their symbols, in UTF-8 or
/// Latin-1), which may differ between the lines. Then scale.length must be
/// empty, and scale.height_unit as well unless the file has no value units.
///
/// Any other file is a plain matrix: scale.length is its period in x, pixels
/// are square, and scale.height_unit is the unit of its numbers. Neither has a
/// default.
///
/// @param format  automatic: Gwyddion if a comment contains a width
/// @throws cases::CaseError  with name:line of the error in the file, or the
///                           key of the case that is missing or superfluous
HeightMap read_height_map_text(std::string_view text, const std::string& name,
                               cases::MapFormat format, const MapScale& scale);
HeightMap read_height_map(const std::string& path, cases::MapFormat format,
                          const MapScale& scale);

} // namespace asperity::surfaces
