#pragma once

// Writes what the browser needs of one figure, as JSON that is safe inside a
// page, and finds the library that draws curves.

#include "reports/explore/chart.hpp"
#include "reports/explore/map_stack.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace asperity::reports {

/// Returns the data of one figure: its maps or, if it has none, its curves. It
/// is "" if the browser could show only a part of the panels, because a curve
/// must not be missing.
///
/// @param name   file name without extension
/// @param table  text of the CSV; the browser reads its numbers
std::string explore_data(const std::string& name, const std::string& title,
                         const std::string& table,
                         std::span<const ChartPanel> panels,
                         const std::optional<MapStack>& maps);

/// Returns the text of Chart.js, the library that draws curves in the browser,
/// or "" if it is not installed. The file is the one that the environment
/// variable ASPERITY_CHART_JS names, otherwise that of the Debian package
/// libjs-chart.js.
std::string chart_library();

/// The script of this program that makes the figures of a page explorable.
std::string explore_script();

/// Returns a script that may stand between <script> and </script> of a page
/// that is also well-formed XML.
std::string inline_script(std::string script);

/// Returns the source expression of a Content-Security-Policy that permits
/// this script and no other: 'sha256-...'.
std::string script_permission(const std::string& script);

} // namespace asperity::reports
