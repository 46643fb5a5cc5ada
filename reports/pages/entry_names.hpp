#pragma once

// The names of several results in one report.

#include "reports/figures/series.hpp"

#include <span>
#include <string>

namespace asperity::reports {

/// Gives every result another name (summary.case_name): its label, or the name
/// of its case. Results of one case are named by the keys in which they differ,
/// "polymer (surface.points = 256)", or else by their folders.
/// @param labels  in the order of the results; empty, or "": no label
void name_entries(std::span<ReportEntry> entries,
                  std::span<const std::string> labels);

} // namespace asperity::reports
