#pragma once

// Reads named quantities from the tables of the studies, as [expect] and
// reference.csv request them: "adhesion_flip", "mean_gap_ratio@p=10
// MPa@zeta=10".

#include "reports/analysis/summary.hpp"

#include <span>
#include <string>

namespace asperity::reports {

/// Adds to the summary of a theory epsilon of Eq. (16) of Yang and Persson
/// (2008) and, if it is the theory of the case's studies, the quantities of
/// their tables. Quantities at a magnification are added only if `names`
/// requests them. An estimate has no value, but a reason, if a table lacks the
/// quantity.
void add_study_quantities(const results::Result& result,
                          const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          std::span<const std::string> names,
                          MethodSummary& summary);

} // namespace asperity::reports
