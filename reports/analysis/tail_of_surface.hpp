#pragma once

// Estimates the expected behaviour of the highest parts of a Gaussian surface,
// in addition to the theory of its case. The two quantities distinguish a small
// system (Sec. 6 of Yang and Persson 2008) from an infinite surface.

#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// Adds to a theory that used the analytical spectrum of a self-affine case
///  - highest_asperity: expected_highest() of a cell of the case's length
///  - asperity_shortfall: (u_theory - u)/h_rms at the lightest load, with u of
///    Bush, Gibson and Thomas, which describes asperities of an infinite
///    surface that do not interact
void add_tail_quantities(const results::Result& result,
                         const cases::Case& contact_case,
                         const results::MethodRecord& method,
                         MethodSummary& summary);

} // namespace asperity::reports
