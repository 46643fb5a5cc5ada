#pragma once

// Connects the two parts of the page's data: the description of each result,
// and the tables of fits, failed steps and figures. It is internal to the page.

#include "reports/pages/agreement.hpp"
#include "reports/pages/html_report.hpp"

#include <kainjow/mustache.hpp>
#include <string>
#include <string_view>

namespace asperity::reports {

/// Returns the head of one result: sentence, banner, methods, verdicts and
/// provenance.
kainjow::mustache::data entry_data(const ReportEntry& entry,
                                   std::span<const Series> series,
                                   bool is_one_of_many);

/// Returns {"text": text}, an item of a list.
kainjow::mustache::data text_item(const std::string& text);

/// Returns the page of a template. Every template may name the parts that all
/// pages share: {{> page_head}}, which ends with the style sheet and shows the
/// `page_title`, {{> page_facts}}, {{> figure}} and {{> page_end}}.
std::string rendered_page(std::string_view page_template,
                          kainjow::mustache::data page);

/// Returns one row per expectation and method.
kainjow::mustache::list verdict_rows(const Summary& summary);

/// Returns "All 6 expectations are met.", and how many are undecided.
std::string banner_words(const Summary& summary);

/// Returns "good", "bad", or "none": nothing was checked, or something is
/// undecided.
std::string banner_class(const Summary& summary);

kainjow::mustache::list fit_rows(std::span<const Series> series);

/// Lists what the run did not compute, with the estimated cost.
kainjow::mustache::list skipped_rows(const results::Result& result);

/// Lists each method with its largest differences from the reference method.
kainjow::mustache::list agreement_rows(std::span<const Agreement> agreements);

/// Lists the largest bound and the largest estimate of the error of the mean
/// gap of each method but the theories; the list is empty if there is none.
kainjow::mustache::list certified_rows(const ReportEntry& entry);

/// Lists area, mean gap and iterations at each load step of the first
/// half-space with free boundaries beside the first periodic one, on
/// realisation 0; the list is empty if one of them is missing.
kainjow::mustache::list boundary_rows(const ReportEntry& entry);

/// Lists the stiffness of the contact and the centre of pressure, at each
/// converged load step of realisation 0 that has a stiffness or whose centre is
/// more than 1e-6 of the side off the middle.
kainjow::mustache::list stiffness_rows(const results::Result& result);

/// Lists partial slip by tangential load and method, means over the
/// realisations (reports/analysis/partial_slip.hpp).
kainjow::mustache::list slip_rows(const ReportEntry& entry);

/// What the rows mean for a case with [friction].
std::string slip_note(const ReportEntry& entry);

/// Lists pressure, load, contact area and mean gap of the first method that is
/// no theory in the units of a laboratory, with 95 % intervals over the
/// realisations.
kainjow::mustache::list physical_rows(const ReportEntry& entry);

/// Lists the cost of each finite-element method and of the half-space method if
/// one of them solved a full 3-D block; otherwise the list is empty.
kainjow::mustache::list block_cost_rows(const results::Result& result);

kainjow::mustache::list group_data(std::span<const DrawnGroup> groups);

/// Shows the first figure beside the key numbers if it is a curve, and all
/// others in their groups.
void set_groups(kainjow::mustache::data& page,
                std::span<const DrawnGroup> groups);

/// Lists the sections of the page that are always there or that matter most.
kainjow::mustache::list contents_of(const kainjow::mustache::data& page);

/// Opens all folded parts of a page.
std::string unfolded(std::string html);

/// Adds to the page what makes its figures explorable: the scripts, and the
/// policy that permits no others and no network access.
/// @param own_script  a further script of this page, or empty
void set_scripts(kainjow::mustache::data& page,
                 std::span<const DrawnGroup> groups, bool is_for_print,
                 const std::string& own_script = {});

/// Adds the groups of figures and their scripts to a page that shows nothing
/// else.
void set_figures(kainjow::mustache::data& page,
                 std::span<const DrawnGroup> groups, bool is_for_print);

} // namespace asperity::reports
