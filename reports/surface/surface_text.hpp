#pragma once

// Writes a surface report as text for a terminal, and its spectrum as a table
// that a case can read.

#include "reports/surface/surface_report.hpp"

#include <string>

namespace asperity::reports {

/// Returns the tables of all maps and lines, the reliable ranges, the fitted
/// models and the predicted contact.
std::string surface_text(const SurfaceReport& report);

/// Returns the rows as the text that `kind = "spectrum"` reads, q [1/m] and
/// C [m^4], below a comment that says where they came from.
std::string spectrum_text(const std::vector<surfaces::SpectrumRing>& rows,
                          const std::string& comment);

} // namespace asperity::reports
