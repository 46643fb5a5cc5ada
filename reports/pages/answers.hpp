#pragma once

// What a user asked of a contact, answered in sentences: the one source of the
// first paragraph of a page, of the end of a command's output and of "answers"
// in summary.json.

#include "reports/analysis/asked_interval.hpp"
#include "reports/figures/series.hpp"

#include <string>
#include <vector>

namespace asperity::reports {

/// Area and mean gap at the lightest, a middle and the heaviest load with their
/// intervals, what yielded and whether the faces stick, and the sentence of
/// each study, in this order; empty if nothing was computed.
std::vector<std::string> answers_of(const ReportEntry& entry);

/// What a curve of the user's own says beside a result: its gamma on the surface
/// of that, by the whole curve and by the slope, with the intervals of the fits,
/// and how far it is from each method of the result.
std::vector<std::string> curve_answers(const ReportEntry& curve,
                                       const ReportEntry& beside);

/// The sources of error of area and mean gap; empty if nothing was computed.
std::vector<IntervalPart> interval_parts(const ReportEntry& entry);

/// " (fem)": the method that a sentence tells, or "" if it is the only one that
/// is no theory.
std::string method_in_words(const ReportEntry& entry,
                            const results::MethodRecord& method);

} // namespace asperity::reports
