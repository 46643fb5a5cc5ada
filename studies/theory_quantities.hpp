#pragma once

// Quantities that [expect] and reference.csv read from tables of the theory.

#include "reports/analysis/summary.hpp"

#include <string>
#include <vector>

namespace asperity::studies {

/// An estimate without a value.
reports::Estimate without(const std::string& reason);

/// The number of a formula; without a value and with the reason if it is NaN.
reports::Estimate number(double value, const std::string& reason_if_none);

/// Interpolates y at x between rows, linearly in the logarithms; NaN outside
/// the rows, and between rows whose y are not positive.
double between_rows(const std::vector<double>& x, const std::vector<double>& y,
                    double at);

/// Whether a record is that of the theory that evaluates the studies.
bool is_study_theory(const cases::Case& contact_case,
                     const results::MethodRecord& method);

} // namespace asperity::studies
