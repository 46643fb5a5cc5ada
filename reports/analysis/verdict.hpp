#pragma once

// Expectations held against what was measured, and how the verdict is told: a
// line on the terminal, JUnit XML for a CI server, JSON for programs.

#include "reports/analysis/summary.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// One verdict an expectation and method, in the order of the case.
/// ok: the value lies in the band and so does its interval, where there is one;
/// failed: neither the value nor any part of its interval does; undecided: the
/// interval reaches over an end of the band.
/// @param is_complete  the run came to its end: a method it does not have was
///                     left out on purpose and is skipped, not missing
std::vector<Verdict> judge(std::span<const cases::Expectation> expectations,
                           std::span<const MethodSummary> methods,
                           bool is_complete = false);

/// "ok" | "failed" | "undecided" | "missing" | "skipped"
const char* outcome_word(Outcome outcome);

/// "0.35..0.45", "<= 1e-04" or ">= 2"; an end that is infinite is left out.
std::string band_text(double low, double high);

/// "ok      fem       gamma_slope   0.412 +- 0.021 in 0.35..0.45"
std::string check_line(const Verdict& verdict);

/// Why nothing was checked and what to do about it; "" if an expectation was
/// held against a method.
std::string why_nothing_checked(const Summary& summary);

/// Each published value with the numbers of the methods that have a quantity
/// of its name.
std::vector<PublishedValue>
beside_ours(std::span<const cases::ReferenceValue> references,
            std::span<const MethodSummary> methods);

/// "0.4 +- 0.05", "1.4e-08 +- 5e-10 m"; exact values have no "+-".
std::string published_text(const cases::ReferenceValue& reference);

/// "paper    gamma_slope          0.4 +- 0.05: fem 0.446, theory 0.448", or
/// "exact    ..." if the value has no uncertainty.
std::string published_line(const PublishedValue& published);

/// One test suite a result, one test case a verdict; of a case without
/// expectations one test case that is skipped.
std::string junit_xml(std::span<const Summary> summaries);

/// Fits with intervals and windows, expectations and published numbers with
/// verdicts, timings and provenance. Numbers that do not exist are null.
std::string summary_json(const Summary& summary);

} // namespace asperity::reports
