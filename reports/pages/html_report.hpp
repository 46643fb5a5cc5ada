#pragma once

// Writes report.html: one self-contained file without network access, complete
// without scripts. It owns the text around the numbers; the layout is
// report.html.mustache.

#include "reports/figures/series.hpp"
#include "reports/pages/drawn_groups.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Returns what report.html.mustache shows. Figures are embedded; for one that
/// could not be drawn, its title, its caption and the reason are shown.
/// @param summaries  what summary.json says of each result
nlohmann::ordered_json
report_page(std::span<const ReportEntry> entries,
            std::span<const nlohmann::ordered_json> summaries,
            std::span<const DrawnGroup> groups);

/// Returns summary.json as it is written beside the page: with the warnings and
/// the tables that some results have (docs/reference/results.md): boundaries,
/// stiffness, partial slip, cost of full 3-D blocks, what was not computed.
nlohmann::ordered_json page_summary(const ReportEntry& entry);

/// Describes the contact problem in one sentence: surface, material and loads.
std::string case_sentence(const ReportEntry& entry);

/// Says the same as a section on methods does: "An elastic block with E* =
/// 2 GPa was pressed against a rigid measured surface of 512 × 512 points ...".
std::string setup_sentences(const ReportEntry& entry);

} // namespace asperity::reports
