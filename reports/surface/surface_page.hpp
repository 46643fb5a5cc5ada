#pragma once

// Writes the page of `asperity surface` with its figures.

#include "reports/pages/report.hpp"
#include "reports/surface/surface_report.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::reports {

/// Writes report.html, surface.json, spectrum.txt and figures/ into `folder`,
/// and what `extras` asks for.
/// @return  the figures that could not be drawn, one line each
/// @throws std::system_error  a file cannot be written
std::vector<std::string>
write_surface_report(const SurfaceReport& report,
                     const std::filesystem::path& folder,
                     const ReportExtras& extras = {});

} // namespace asperity::reports
