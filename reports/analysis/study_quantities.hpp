#pragma once

// Named numbers of the studies' tables, as [expect] and reference.csv ask for
// them: "adhesion_flip", "mean_gap_ratio@p=10 MPa@zeta=10".

#include "reports/analysis/summary.hpp"

#include <span>
#include <string>

namespace asperity::reports {

/// Adds to a theory's summary eps of (16) and, where it is the theory of the
/// case's studies, what their tables say; those at a magnification only as
/// `names` asks. Without a value, and with the reason, where a table lacks it.
void add_study_quantities(const results::Result& result,
                          const cases::Case& contact_case,
                          const results::MethodRecord& method,
                          std::span<const std::string> names,
                          MethodSummary& summary);

} // namespace asperity::reports
