#pragma once

// The two halves of the page's data meet here: what is said of each result,
// and the tables of fits, failed steps and figures. Internal to the page.

#include "reports/pages/html_report.hpp"

#include <kainjow/mustache.hpp>

namespace asperity::reports {

/// Head of one result: sentence, banner, methods, verdicts, provenance.
kainjow::mustache::data entry_data(const ReportEntry& entry,
                                   std::span<const Series> series,
                                   bool is_one_of_many);

/// {"text": text}, an item of a list.
kainjow::mustache::data text_item(const std::string& text);

/// The style sheet that all pages share, as a <style> element.
std::string shared_style();

/// A row an expectation and method.
kainjow::mustache::list verdict_rows(const Summary& summary);

/// "All 6 expectations are met.", and how many are undecided.
std::string banner_words(const Summary& summary);

/// "good", "bad", or "none": nothing was judged, or something is undecided.
std::string banner_class(const Summary& summary);

kainjow::mustache::list fit_rows(std::span<const Series> series);

/// What the run did not compute, with what it would have cost.
kainjow::mustache::list skipped_rows(const results::Result& result);

/// What each finite-element method and the half-space cost, where one of them
/// solved a whole block; else none.
kainjow::mustache::list block_cost_rows(const results::Result& result);

kainjow::mustache::list failed_step_rows(std::span<const ReportEntry> entries);

kainjow::mustache::list group_data(std::span<const DrawnGroup> groups);

} // namespace asperity::reports
