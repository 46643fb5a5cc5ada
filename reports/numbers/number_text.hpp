#pragma once

// Formats a number with its unit or its confidence interval for a page or a
// figure.

#include "reports/numbers/estimate.hpp"

#include <string>

namespace asperity::reports {

/// Returns "0.412 ± 0.021", with as many decimals as the interval justifies;
/// four digits if there is no interval; "not determined" if there is no value.
std::string number_text(const Estimate& estimate);

/// Returns the same in per cent: "+27.1 ± 0.9 %".
std::string percent_text(const Estimate& estimate);

/// Returns a number with its unit, "5.98 nm", "1.25e+06 1/m" or "3.1" for the
/// unit "1"; m, N and Pa have a prefix that suits the number. "–" if it is not
/// finite.
std::string quantity_text(double value, const std::string& unit,
                          int digits = 4);

} // namespace asperity::reports
