#pragma once

// Writes the panels of a figure as a gnuplot script. It is internal to this
// folder.

#include "reports/figures/gnuplot.hpp"

#include <string>

namespace asperity::reports {

/// Returns the commands that draw the figure from the files in its folder. No
/// part of a text is run as a command; a straight single quote is shown as a
/// typographic one.
std::string gnuplot_script(const Figure& figure);

/// Returns the text of "<name>-bands.csv", the bands of all panels: rows "x,y"
/// of a corner, and two empty lines between bands; empty if there are none.
std::string band_file(const Figure& figure);

} // namespace asperity::reports
