#pragma once

// The room's front door: results in, a report folder out.

#include "reports/figures/series.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Writes folder/report.html, folder/figures/* (SVG, CSV and gnuplot script of
/// each figure) and, for a single result, folder/summary.json. Several results
/// share their curve figures; the maps of each are in a folder of their own.
/// A figure that cannot be drawn is said in the report and is no error.
///
/// @param gnuplot  name or path of the program
/// @return         the figures that could not be drawn, "name: why"
/// @throws std::system_error  the folder cannot be written
std::vector<std::string> write_report(std::span<const ReportEntry> entries,
                                      const std::filesystem::path& folder,
                                      const std::string& gnuplot = "gnuplot");

/// The same from results alone: each result's own case text is read again.
/// @throws cases::CaseError  a result's case text has mistakes
std::vector<std::string> write_report(std::span<const results::Result> results,
                                      const std::filesystem::path& folder,
                                      const std::string& gnuplot = "gnuplot");

/// The case a result was made from, read from its own text. `path` of the
/// messages is that of the result. A result without a text, as other codes
/// write it, is of a measured surface, without expectations.
cases::Case case_of(const results::Result& result);

/// A result with its case and its summary. Both arguments must outlive it.
ReportEntry entry_of(const results::Result& result,
                     const cases::Case& contact_case);

} // namespace asperity::reports
