#pragma once

// This internal header of surfaces/formats finds the sizes and units in the
// header lines of a text matrix.

#include "surfaces/formats/text/number_table.hpp"

#include <optional>

namespace asperity::surfaces {

/// The lines of Gwyddion's header, without their keys; line 0: there is none.
struct GwyddionHeader {
  CommentLine channel;
  CommentLine width;
  CommentLine height;
  CommentLine value_units;
};

/// Finds the lines "Channel:", "Width:", "Height:" and "Value units:". Because
/// Gwyddion translates these words, two lines "word: number and unit of length"
/// are taken for width and height in any language, in this order, a line "word:
/// unit" behind them for the unit of the values, and a line "word: text" before
/// them for the channel.
GwyddionHeader gwyddion_header(const NumberTable& table);

/// Header of matrices written by interferometers:
///
///     h=650 w=650
///     pixel size=3.69862e-007 m
///     height conversion factor (-> m)=6.30079e-008
struct MatrixHeader {
  std::optional<double> pixel_size;  ///< [m]
  std::optional<double> height_unit; ///< [m] per unit of the numbers
};

/// @throws input::InputError  with name:line, if h or w is not the number of
///                            rows or columns or a number is not > 0
MatrixHeader matrix_header(const NumberTable& table);

} // namespace asperity::surfaces
