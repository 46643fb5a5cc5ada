#pragma once

// Writes a surface report: as JSON, as text for a terminal, its spectrum as a
// table that a case can read, and the page of `asperity surface`.

#include "reports/pages/report.hpp"
#include "reports/surface/surface_report.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::reports {

/// Returns all numbers of the report; docs/numerics/surface-analysis.md lists
/// the keys. Numbers that are not determined are null.
nlohmann::ordered_json surface_json(const SurfaceReport& report);

/// Returns the tables of all maps and lines, the reliable ranges, the fitted
/// models and the predicted contact.
std::string surface_text(const SurfaceReport& report);

/// Returns the rows as the text that `kind = "spectrum"` reads, q [1/m] and
/// C [m^4], below a comment that says where they came from.
std::string spectrum_text(const std::vector<surfaces::SpectrumRing>& rows,
                          const std::string& comment);

/// Writes report.html, surface.json, spectrum.txt and figures/ into `folder`,
/// and what `extras` asks for.
/// @return  the figures that could not be drawn, one line each
/// @throws std::system_error  a file cannot be written
std::vector<std::string>
write_surface_report(const SurfaceReport& report,
                     const std::filesystem::path& folder,
                     const ReportExtras& extras = {});

} // namespace asperity::reports
