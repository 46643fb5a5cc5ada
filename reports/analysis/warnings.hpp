#pragma once

// Where the data do not meet the methods' assumptions. Owns the limits and the
// words; the numbers are those of surfaces/assumptions.hpp.

#include "cases/types/case.hpp"
#include "reports/analysis/summary.hpp"
#include "results/types/result.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// One assumption that a surface does not meet.
struct Warning {
  std::string kind;        ///< not_gaussian, not_resolved, too_steep,
                           ///< scan_lines or windowed
  std::string headline;    ///< one sentence, with the number and its limit
  std::string consequence; ///< what this means for the result
};

/// Limits, and why they lie there: docs/surfaces.md, "What a report warns of".
struct WarningLimits {
  static constexpr double skewness = 1.0;         ///< either sign [1]
  static constexpr double kurtosis_low = 2.0;     ///< [1], 3: Gaussian
  static constexpr double kurtosis_high = 5.0;    ///< [1]
  static constexpr double unresolved_slope = 0.6; ///< share of <|grad h|^2>
  static constexpr double rms_slope = 0.5;        ///< [1]
  static constexpr double line_offset = 3.0;      ///< ratio, or one over it
};

/// What a report says at its top: of a self-affine surface, one by a spectrum
/// and a measured one (exact shapes are what they are). Moments and slopes are
/// means over the realisations, what needs heights is of realisation 0; a
/// number that is not in the result warns of nothing.
std::vector<Warning> warnings_of(const results::Result& result,
                                 const cases::Case& contact_case);

/// The same for a terminal: "warning: case: headline", a line each.
std::string warning_lines(const results::Result& result,
                          const cases::Case& contact_case);

/// summary.json with these among it.
std::string summary_json(const Summary& summary,
                         std::span<const Warning> warnings);

} // namespace asperity::reports
