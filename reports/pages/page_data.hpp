#pragma once

// What pages are made of, as JSON for their templates: figures and their
// scripts, and the parts of the page of results. It is internal to the pages.

#include "reports/pages/agreement.hpp"
#include "reports/pages/html_report.hpp"
#include "reports/pages/rendered_page.hpp"

#include <string>

namespace asperity::reports {

/// Returns what the page shows of one result beside its summary.json.
nlohmann::ordered_json entry_page(const ReportEntry& entry,
                                  nlohmann::ordered_json page,
                                  std::span<const Series> series);

/// Returns "All 6 expectations are met.", and how many are undecided; "" if the
/// case states none.
std::string banner_words(const Summary& summary);

/// Returns "good", "bad", or "none": nothing was checked, or something is
/// undecided.
std::string banner_class(const Summary& summary);

/// Pressure, load, contact area and mean gap of the first method that is no
/// theory, with 95 % intervals over the realisations and the errors of
/// AskedIntervals, which include these.
nlohmann::ordered_json contact_against_load(const ReportEntry& entry);

/// Describes each group with its heading, its anchor and its figures.
nlohmann::ordered_json group_data(std::span<const DrawnGroup> groups);

/// Shows the figures that answer first, gap and area against the load or the
/// path of contact with adhesion, beside the answer, and all others in their
/// groups.
void set_groups(nlohmann::ordered_json& page,
                std::span<const DrawnGroup> groups);

/// Lists the sections of the page that are always there or that matter most.
nlohmann::ordered_json contents_of(const nlohmann::ordered_json& page);

/// Opens all folded parts of a page.
std::string unfolded(std::string html);

/// Adds to the page what makes its figures explorable: the scripts, and the
/// policy that permits no others and no network access.
/// @param own_script  a further script of this page, or empty
void set_scripts(nlohmann::ordered_json& page,
                 std::span<const DrawnGroup> groups, bool is_for_print,
                 const std::string& own_script = {});

/// Adds the groups of figures and their scripts to a page that shows nothing
/// else.
void set_figures(nlohmann::ordered_json& page,
                 std::span<const DrawnGroup> groups, bool is_for_print);

} // namespace asperity::reports
