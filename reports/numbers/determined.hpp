#pragma once

// Whether a fitted number is a result. Owns the rules by which one is "not
// determined" and the words that say why.

#include "reports/numbers/estimate.hpp"

#include <limits>
#include <string>

namespace asperity::reports {

/// The numbers that a fitted quantity can mean anything for: those above `low`,
/// up to and including `high`.
struct MeaningfulRange {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
};

/// gamma, as slope or as parameter: (10) mixes with weights gamma and 1 -
/// gamma.
inline constexpr MeaningfulRange gamma_range{0.0, 1.0};
/// beta and kappa.
inline constexpr MeaningfulRange positive_range{};

/// Why value +- half_width is no result, "" if it is one. It is none if
///  - the value is not finite or lies outside the range,
///  - there is no interval, as of a line through two points,
///  - the 95 % interval, twice half_width, is wider than the value.
std::string why_undetermined(double value, double half_width,
                             const MeaningfulRange& range);

/// The estimate, or one without a value whose remark is the reason. An estimate
/// without a value, and one that the case sets, are returned as they are.
Estimate determined(const Estimate& estimate, const MeaningfulRange& range);

/// Why one realisation's own fit is no result; see why_undetermined().
std::string why_undetermined(const FittedValue& fitted,
                             const MeaningfulRange& range);

/// The fit as it is shown: without a value, but with the reason, where it is no
/// result.
FittedValue determined(const FittedValue& fitted, const MeaningfulRange& range);

/// What is shown in place of a number that there is not.
inline constexpr const char* undetermined_word = "not determined";

} // namespace asperity::reports
