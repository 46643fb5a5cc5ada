#pragma once

// report.html: one self-contained file, no network, no script. Owns the words
// around the numbers; the look is report.html.mustache.

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/series.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Figures that belong together under one heading; empty heading: none.
struct DrawnGroup {
  std::string heading;
  std::vector<DrawnFigure> figures;
};

/// The page. Figures are embedded; one that could not be drawn leaves its
/// title, its caption and the reason.
std::string html_page(std::span<const ReportEntry> entries,
                      std::span<const DrawnGroup> groups);

/// What was pressed on what: surface, material and loads in one sentence.
std::string case_sentence(const ReportEntry& entry);

} // namespace asperity::reports
