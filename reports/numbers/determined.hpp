#pragma once

// Decides whether a fitted number counts as a result. It owns the rules by
// which a number is "not determined" and the messages that state the reason.

#include "reports/numbers/estimate.hpp"

#include <limits>
#include <string>

namespace asperity::reports {

/// The interval in which a fitted quantity is meaningful: above `low`, up to
/// and including `high`.
struct MeaningfulRange {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
};

/// Range of gamma, as a slope or as a parameter: Eq. (10) of Yang and Persson
/// (2008) uses the weights gamma and 1 - gamma.
inline constexpr MeaningfulRange gamma_range{0.0, 1.0};
/// Range of beta and kappa.
inline constexpr MeaningfulRange positive_range{};

/// Returns the reason why value +- half_width is not a result; "" if it is one.
/// It is not a result if
///  - the value is not finite or lies outside the range,
///  - there is no interval, as for a line through two points,
///  - the 95 % interval, twice half_width, is wider than the value.
std::string why_undetermined(double value, double half_width,
                             const MeaningfulRange& range);

/// Returns the estimate, or an estimate without a value whose remark is the
/// reason. An estimate without a value and one that the case prescribes are
/// returned unchanged.
Estimate determined(const Estimate& estimate, const MeaningfulRange& range);

/// Returns the reason why the fit of one realisation is not a result; see
/// why_undetermined() above.
std::string why_undetermined(const FittedValue& fitted,
                             const MeaningfulRange& range);

/// Returns the fit in the form in which it is shown: if it is not a result,
/// without a value but with the reason.
FittedValue determined(const FittedValue& fitted, const MeaningfulRange& range);

/// Text shown in place of a number that does not exist.
inline constexpr const char* undetermined_word = "not determined";

} // namespace asperity::reports
