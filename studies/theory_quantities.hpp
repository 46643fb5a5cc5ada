#pragma once

// Quantities that [expect] and reference.csv read from tables of the theory.

#include "input/types/expectations.hpp"
#include "reports/analysis/summary.hpp"

#include <string>
#include <vector>

namespace asperity::studies {

/// A quantity that study_theory() alone provides, in a case with the table of
/// the study.
cases::ExpectationName
quantity_of_theory(const char* name, const char* description, const char* study,
                   cases::QuantityOf of = cases::QuantityOf::curve);

/// Interpolates y at x between rows, linearly in the logarithms; NaN outside
/// the rows, and between rows whose y are not positive.
double between_rows(const std::vector<double>& x, const std::vector<double>& y,
                    double at);

/// Whether a record is that of the theory that evaluates the studies.
bool is_study_theory(const cases::Case& contact_case,
                     const results::MethodRecord& method);

} // namespace asperity::studies
