#pragma once

// Detects where the data violate the assumptions of the methods. It owns the
// limits and the messages; the numbers come from surfaces/assumptions.hpp.

#include "input/types/case.hpp"
#include "reports/analysis/summary.hpp"
#include "results/types/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// One assumption that a surface or a method violates.
struct Warning {
  std::string kind;        ///< not_gaussian, not_resolved, too_steep,
                           ///< scan_lines, few_digits, tilted, noise, windowed,
                           ///< locking, oscillating_heights, omitted,
                           ///< recess_touches,
                           ///< no_contact, theory_area or theory_gap
  std::string headline;    ///< one sentence, with the number and its limit
  std::string consequence; ///< what this means for the result
  /// What is wrong and what helps, in at most 20 words: what a page and the
  /// terminal show first.
  std::string line;
  /// Whether it follows from case and map alone: a run tells it before its
  /// first step.
  bool is_known_before = false;
};

/// The limits are motivated in docs/numerics/surfaces.md, "What a report warns
/// of".
struct WarningLimits {
  static constexpr double skewness = 1.0;     ///< absolute value [1]
  static constexpr double kurtosis_low = 2.0; ///< [1]; a Gaussian surface has 3
  static constexpr double kurtosis_high = 5.0;    ///< [1]
  static constexpr double unresolved_slope = 0.6; ///< share of <|grad h|^2>
  static constexpr double noise_slope = 0.2;      ///< share of <|grad h|^2>
  static constexpr double rms_slope = 0.5;        ///< [1]
  static constexpr double line_offset = 3.0;      ///< ratio or its inverse [1]
  static constexpr double height_step = 1e-3;     ///< over the rms height [1]
  static constexpr double tilt = 10.0; ///< rms height over that about a plane
};

/// Returns the warnings at the top of a report: finite elements of the result
/// that lock (input/reader/locking.hpp), curves without any contact, loads at
/// which the theory does not agree (theory_agreement.hpp), and assumptions
/// about self-affine surfaces, surfaces given by a spectrum and measured ones
/// (exact shapes need none). Moments and slopes are means over the
/// realisations; quantities that need heights use realisation 0. A number that
/// is not in the result causes no warning.
std::vector<Warning> warnings_of(const results::Result& result,
                                 const cases::Case& contact_case);

/// Returns the same for a terminal: "warning: case: line", one line each.
/// @param has_run  without those that the run has told
std::string warning_lines(const results::Result& result,
                          const cases::Case& contact_case,
                          bool has_run = false);

/// Returns what summary_json() writes, with these warnings.
nlohmann::ordered_json summary_data(const Summary& summary,
                                    std::span<const Warning> warnings);

} // namespace asperity::reports
