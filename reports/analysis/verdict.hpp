#pragma once

// Compares expectations with results and formats the verdict: a line on the
// terminal, JUnit XML for a CI server, JSON for programs.

#include "reports/analysis/summary.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Returns one verdict per expectation and method, in the order of the case.
/// ok: the value lies in the band and so does its interval, if there is one;
/// failed: neither the value nor any part of its interval does; undecided: the
/// interval contains an end of the band.
/// @param is_complete  the run has finished: a method that is absent was
///     deliberately omitted and is skipped, not missing
std::vector<Verdict> judge(std::span<const cases::Expectation> expectations,
                           std::span<const MethodSummary> methods,
                           bool is_complete = false);

/// Returns "ok" | "failed" | "undecided" | "missing" | "skipped".
const char* outcome_word(Outcome outcome);

/// Returns "0.35..0.45", "<= 1e-04" or ">= 2"; an infinite end is omitted.
std::string band_text(double low, double high);

/// Formats "ok      fem       gamma_slope   0.412 ± 0.021 in 0.35..0.45".
std::string check_line(const Verdict& verdict);

/// Explains why nothing was checked and what to do about it; "" if at least one
/// expectation was compared with a method.
std::string why_nothing_checked(const Summary& summary);

/// Returns each published value together with the results of the methods that
/// have a quantity of that name.
std::vector<PublishedValue>
beside_ours(std::span<const cases::ReferenceValue> references,
            std::span<const MethodSummary> methods);

/// Formats "0.4 ± 0.05", "14.00 ± 0.50 nm"; exact values have no "±".
std::string published_text(const cases::ReferenceValue& reference);

/// Formats a published value and the computed ones as
///
///     paper    gamma_slope          0.4 ± 0.05: fem 0.446, theory 0.448
///
/// or as "exact    ..." if the published value has no uncertainty.
std::string published_line(const PublishedValue& published);

/// Writes one test suite per result and one test case per verdict, with value,
/// interval, band and verdict as properties. Its time is the CPU time of its
/// method, divided by the number of verdicts on that method. A case without
/// expectations has one test case, which is skipped.
std::string junit_xml(std::span<const Summary> summaries);

/// Text by which a file of junit_xml() is recognised.
inline constexpr const char* junit_root = "<testsuites name=\"asperity\"";

/// Writes fits with intervals and windows, expectations and published numbers
/// with verdicts, timings and provenance. Numbers that do not exist are null.
std::string summary_json(const Summary& summary);

} // namespace asperity::reports
