#include "reports/numbers/determined.hpp"

#include <fmt/format.h>

#include <cmath>

namespace asperity::reports {
namespace {

std::string range_words(const MeaningfulRange& range) {
  return std::isfinite(range.high)
             ? fmt::format("above {:g} and up to {:g}", range.low, range.high)
             : fmt::format("above {:g}", range.low);
}

} // namespace

std::string why_undetermined(double value, double half_width,
                             const MeaningfulRange& range) {
  if (!std::isfinite(value))
    return "the fit gives no finite number";
  if (!(value > range.low && value <= range.high))
    return fmt::format("the fit gives {:.3g}, but only numbers {} have a "
                       "meaning",
                       value, range_words(range));
  if (!std::isfinite(half_width))
    return "the fit has no confidence interval";
  if (2.0 * half_width > std::abs(value))
    return fmt::format("the 95 % interval of the fit, {:.3g} to {:.3g}, is "
                       "wider than the value",
                       value - half_width, value + half_width);
  return "";
}

Estimate determined(const Estimate& estimate, const MeaningfulRange& range) {
  if (estimate.is_input || !estimate.has_value())
    return estimate;
  const std::string why =
      why_undetermined(estimate.value, estimate.half_width, range);
  if (why.empty())
    return estimate;
  Estimate none;
  none.realizations = estimate.realizations;
  none.remark = why;
  if (!estimate.remark.empty())
    none.remark += " (" + estimate.remark + ")";
  return none;
}

std::string why_undetermined(const FittedValue& fitted,
                             const MeaningfulRange& range) {
  return why_undetermined(
      fitted.value,
      student_half_width(fitted.standard_error, fitted.degrees_of_freedom),
      range);
}

FittedValue determined(const FittedValue& fitted,
                       const MeaningfulRange& range) {
  const bool has_value = fitted.value == fitted.value;
  const std::string why =
      has_value ? why_undetermined(fitted, range) : fitted.reason;
  return why.empty() && has_value ? fitted : FittedValue{.reason = why};
}

} // namespace asperity::reports
