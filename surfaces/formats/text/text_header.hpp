#pragma once

// This internal header of surfaces/formats finds the sizes and units in the
// header lines of a text matrix.

#include "surfaces/formats/scan.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::surfaces {

/// The lines of Gwyddion's header, without their keys; line 0: there is none.
struct GwyddionHeader {
  CommentLine channel;
  CommentLine width;
  CommentLine height;
  CommentLine value_units;
};

/// Finds the lines "Channel:", "Width:", "Height:" and "Value units:". Because
/// Gwyddion translates these words, a line "word: number and unit of length"
/// whose word is the width in a language of Gwyddion is taken for the width,
/// the next such line for the height, a line "word: unit" behind them for the
/// unit of the values, and a line "word: text" before them for the channel.
GwyddionHeader gwyddion_header(const NumberTable& table);

/// Header of a matrix: of interferometers,
///
///     h=650 w=650
///     pixel size=3.69862e-007 m
///     height conversion factor (-> m)=6.30079e-008
///
/// of ESRI grids (ncols, nrows, cellsize, NODATA_value, in any case of
/// letters), SPIP (File Format = ASCII, with x-pixels, x-length [nm], z-unit,
/// ...) and Keyence ("XY Calibration","277","nm/pixel" and "Unit","um").
struct MatrixHeader {
  std::optional<double> length_x, length_y; ///< [m]
  std::optional<double> cell_size;          ///< side of a pixel, without a unit
  std::optional<double> height_unit;        ///< [m] per unit of the numbers
  std::optional<double> missing_value; ///< number at points without a height
  /// Other lines for which names_size() is true.
  std::vector<CommentLine> not_understood;
};

/// @throws input::InputError  with name:line, if a number of rows or columns is
///                            another one than that of the table, or a number
///                            is not > 0
MatrixHeader matrix_header(const NumberTable& table);

/// Whether a word begins a header line of an ESRI grid.
bool is_grid_key(std::string_view word);

/// Whether a header line states a length, or a number or unit beside a word
/// such as size, pixel or range.
bool names_size(const CommentLine& comment);

/// Refuses header lines that name sizes or units, unless they only repeat what
/// is known.
/// @param known_lengths  of the map [m]
/// @param known_units    of its numbers [m]
/// @throws input::InputError  with name:line
void require_understood(const std::vector<CommentLine>& lines,
                        const std::string& name,
                        const std::vector<double>& known_lengths,
                        const std::vector<double>& known_units);

/// The same for a list x y z, whose columns may have a unit each.
void require_list_header(const NumberTable& table, const MapScale& scale);

} // namespace asperity::surfaces
