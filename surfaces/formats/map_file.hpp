#pragma once

// Measured height maps in text files. Owns what Gwyddion and scripts write:
// headers, length units and the orientation of a matrix.

#include "cases/types/case.hpp"
#include "surfaces/maps/height_map.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace asperity::surfaces {

/// What a case says about a map because its file does not.
struct MapScale {
  std::optional<double> length;      ///< side in x [m] > 0
  std::optional<double> height_unit; ///< m per unit of the file's numbers > 0
};

/// Reads a matrix of heights as it is: nothing levelled, the mean left in.
/// Columns go along x, rows along y from the first line on; a map may be
/// rectangular and of odd size. Numbers as read_number_text takes them.
///
/// Gwyddion's text matrix begins with the lines
///
///     # Width: 20.0 um          period in x, number and length unit
///     # Height: 20.0 um         period in y
///     # Value units: nm         of the numbers
///
/// with m, mm, um, nm, pm or angstrom (or their signs, in UTF-8 or Latin-1),
/// not necessarily one unit for all. Then scale.length must be empty, and
/// scale.height_unit as well unless the file says no value units.
///
/// A plain matrix is anything else: scale.length is its period in x, pixels
/// are square, and scale.height_unit is what its numbers count. Neither has a
/// default.
///
/// @param format  automatic: Gwyddion if a comment says a width
/// @throws cases::CaseError  with name:line of what is wrong in the file, or
///                           the key of the case that is missing or too much
HeightMap read_height_map_text(std::string_view text, const std::string& name,
                               cases::MapFormat format, const MapScale& scale);
HeightMap read_height_map(const std::string& path, cases::MapFormat format,
                          const MapScale& scale);

} // namespace asperity::surfaces
