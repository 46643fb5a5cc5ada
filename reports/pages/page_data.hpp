#pragma once

// What pages are made of, as JSON for their templates: figures and their
// scripts, and the parts of the page of results. A page is rendered from the
// JSON that a program reads where it is published as a file; numbers are
// formatted there and nowhere else: a template says how.

#include "reports/pages/agreement.hpp"
#include "reports/pages/html_report.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::reports {

/// Returns the members of an object as an array: those that are objects with
/// their names as `key`, others as {"key", "value"}.
nlohmann::ordered_json items_of(const nlohmann::ordered_json& object);

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

/// Returns the page of a mustache template with the scripts of its figures, or
/// for print: unfolded and without them. Every template may name the parts
/// that all pages share: {{> page_head}}, which ends with the style sheet and
/// shows the `page_title`, {{> page_facts}}, {{> figure}} and {{> page_end}}.
///
/// A section of a null, an empty text or a number that is not finite is left
/// out; an array `rows` also sets `has_rows`. A number has its format behind a
/// bar, and without one all its digits:
///
///     {{gap|4g}}          as by {:.4g} of fmt; "–" if it is null
///     {{gap|4g e9 nm}}    times 1e9, with a unit
///     {{gap|4m}}          in metres, with a prefix: "5.98 nm"; also N and Pa
///     {{gap|unit}}        the same in the unit that its object has as `unit`
///     {{gap|key}}         all digits; what is missing is sorted last
///     {{value|±}}         with the half_width_95 of its object: "0.41 ± 0.02";
///                         |±4g e9: in this format
/// @param own_script  a further script of this page, or empty
std::string page_text(std::string_view page_template,
                      nlohmann::ordered_json page,
                      std::span<const DrawnGroup> groups, bool is_for_print,
                      const std::string& own_script = {});

/// Writes a page as folder/report.html, and on request prints report.pdf.
/// @param problems  gets the reason why that was not printed
void write_page(std::string_view page_template,
                const nlohmann::ordered_json& page,
                std::span<const DrawnGroup> groups,
                const std::filesystem::path& folder, bool has_pdf,
                std::vector<std::string>& problems);

} // namespace asperity::reports
