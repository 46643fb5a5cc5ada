#include "reports/numbers/number_text.hpp"

#include "base/shown_number.hpp"
#include "reports/numbers/determined.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace asperity::reports {
namespace {

// Returns the number of decimals, 0..6, at which `uncertainty` has two digits.
int decimals_for(double uncertainty) {
  if (!(uncertainty > 0.0) || !std::isfinite(uncertainty))
    return 3;
  const double digits = 1.0 - std::floor(std::log10(uncertainty));
  return static_cast<int>(std::clamp(digits, 0.0, 6.0));
}

std::string fixed(double value, const char* sign, int decimals) {
  return fmt::format(fmt::runtime(fmt::format("{{:{}.{}f}}", sign, decimals)),
                     Shown{value});
}

} // namespace

std::string number_text(const Estimate& estimate) {
  if (!estimate.has_value())
    return undetermined_word;
  if (!estimate.has_interval())
    return fmt::format("{:.4g}", Shown{estimate.value});
  const double size = std::abs(estimate.value);
  if (estimate.half_width < 1e-9 * size) // roundoff
    return fmt::format("{:.4g}", estimate.value);
  if (estimate.half_width < 1e-4 * size) // too small to be worth printing
    return fmt::format("{:.4g} ± {:.0e}", estimate.value, estimate.half_width);
  return uncertain_text(estimate.value, estimate.half_width, "1");
}

std::string percent_text(const Estimate& estimate) {
  if (!estimate.has_value())
    return undetermined_word;
  if (!estimate.has_interval())
    return std::abs(estimate.value) < 1.0
               ? fmt::format("{:.2g} %", Shown{100.0 * estimate.value})
               : fmt::format("{:.0f} %", Shown{100.0 * estimate.value});
  const int decimals = std::min(1, decimals_for(100.0 * estimate.half_width));
  return fixed(100.0 * estimate.value, "+", decimals) + " ± " +
         fixed(100.0 * estimate.half_width, "", decimals) + " %";
}

} // namespace asperity::reports
