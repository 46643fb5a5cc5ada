#pragma once

// What the highest parts of a Gaussian surface are expected to do, beside the
// theory of its case: the two measures that tell a small system (Sec. 6) from
// a surface without end.

#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// Adds to a theory that took the formula of a self-affine case
///  - highest_asperity: expected_highest() of a cell of the case's length
///  - asperity_shortfall: (theory's u - u)/h_rms at the lightest load, u that
///  of
///    Bush, Gibson and Thomas: asperities of a surface without end, of which
///    none feels another
void add_tail_quantities(const results::Result& result,
                         const cases::Case& contact_case,
                         const results::MethodRecord& method,
                         MethodSummary& summary);

} // namespace asperity::reports
