#pragma once

// Reads back what a figure plots from its gnuplot script, so that the browser
// draws exactly the curves of the printed figure. Only the commands that
// figures of this program write are understood.

#include "reports/explore/chart.hpp"

#include <optional>
#include <string>

namespace asperity::reports {

/// Returns the curves that a script plots from its table.
///
/// Understood are the axis commands (`set xlabel`, `ylabel`, `y2label`,
/// `xrange`, `yrange`, `y2range`, `xtics` with names, `logscale`, and `unset`
/// of these), horizontal bars and vertical lines (`set arrow`, the name of a
/// line by `set label`), shaded ranges (`set object`), and curves of the form
///
///     'file.csv' using ($2==1 ? $3 : NaN):4 with lines title 'name'
///
/// with `lines`, `points`, `linespoints`, `steps`, `xerrorbars`, `yerrorlines`
/// or, between two columns, `filledcurves`, and straight lines "0", "2.5" and
/// "x". Each `plot` is one panel. Commands that only concern the appearance on
/// paper are skipped.
///
/// @param header    first line of the table; a column that is called "log10 X"
///                is shown as X on a logarithmic axis
/// @param polygons  file of the bands, which are filled polygons
///                  (script_bands.hpp); empty: none
/// @return          nothing if any part of a plot is not understood, such as an
///                image, because a curve must not be missing
std::optional<Chart> chart_of_script(const std::string& script,
                                     const std::string& header,
                                     const std::string& polygons = "");

/// Converts gnuplot's markup to plain text: "h_{rms}" to "h_rms", "A_0" to
/// "A₀", "m^4" to "m⁴".
std::string plain_label(const std::string& markup);

} // namespace asperity::reports
