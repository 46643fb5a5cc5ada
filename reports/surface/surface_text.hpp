#pragma once

// Writes a surface report as text for a terminal, and its spectrum as a table
// that a case can read.

#include "reports/surface/surface_report.hpp"

#include <string>

namespace asperity::reports {

/// Returns the tables of all maps and lines, the reliable ranges, the fitted
/// models and the predicted contact.
std::string surface_text(const SurfaceReport& report);

/// Returns the text of spectrum.txt: C(q) within the reliable ranges, with
/// comments that say where it came from.
std::string spectrum_text(const SurfaceReport& report);

} // namespace asperity::reports
