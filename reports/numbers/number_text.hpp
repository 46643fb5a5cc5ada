#pragma once

// A number with its confidence interval as a page or a figure prints it.

#include "reports/numbers/estimate.hpp"

#include <string>

namespace asperity::reports {

/// "0.412 ± 0.021": as many decimals as the interval has meaning for, four
/// digits without one, "not determined" without a value.
std::string number_text(const Estimate& estimate);

/// The same in per cent: "+27.1 ± 0.9 %".
std::string percent_text(const Estimate& estimate);

} // namespace asperity::reports
