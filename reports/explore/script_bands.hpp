#pragma once

// Reads the bands of a figure: closed polygons in a file of their own. It is
// internal to this folder.

#include "reports/explore/chart.hpp"

#include <optional>
#include <string>

namespace asperity::reports {

/// Returns true for a part of a plot that fills an area.
bool is_band(const std::string& part);

/// Reads "'a-bands.csv' index 1 using 1:2 with filledcurves closed fillcolor
/// rgb '#0072B2' ...".
/// @param polygons  the file: rows "x,y", two empty lines between polygons
/// @return          nothing if it is not understood
std::optional<ChartBand> band_of(const std::string& part,
                                 const std::string& polygons);

} // namespace asperity::reports
