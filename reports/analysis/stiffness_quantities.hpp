#pragma once

// This file compares the incremental stiffness of a single contact, and the
// moment of a tilted punch, with the exact solutions on a half-space.

#include "reports/analysis/summary.hpp"

namespace asperity::reports {

/// Adds, if the method has found them, normal_stiffness_error and
/// tangential_stiffness_error for a sphere and an upright punch on a clamped
/// periodic block, after the correction for the strain of the block and the
/// other contacts (theory/exact/contact_stiffness.hpp), and moment_error for a
/// tilted punch whose whole end is in contact. Each is the largest relative
/// error over the converged loading rows.
void add_stiffness_quantities(const results::Result& result,
                              const cases::Case& contact_case,
                              const results::MethodRecord& method,
                              MethodSummary& summary);

} // namespace asperity::reports
