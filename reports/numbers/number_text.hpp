#pragma once

// Formats a number with its unit or its confidence interval for a page or a
// figure.

#include "base/shown_number.hpp"
#include "reports/numbers/estimate.hpp"

#include <string>

namespace asperity::reports {

/// Returns "0.412 ± 0.021", with as many decimals as the interval justifies;
/// four digits if there is no interval; "not determined" if there is no value.
std::string number_text(const Estimate& estimate);

/// Returns the same in per cent: "+27.1 ± 0.9 %".
std::string percent_text(const Estimate& estimate);

using asperity::quantity_text;

} // namespace asperity::reports
