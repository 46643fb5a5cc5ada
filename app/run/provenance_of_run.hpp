#pragma once

// The provenance of one run: program and machine, and what this run was told.

#include "cases/types/case.hpp"
#include "results/provenance.hpp"

namespace asperity::app {

using results::RunClock;

results::Provenance provenance_at_start(const cases::Case& rough_case,
                                        int threads);

/// Of the finite elements, once they were used: loads them.
results::Provenance provenance_of_fem();

} // namespace asperity::app
