#pragma once

// The provenance of one run: program and machine, and what this run was told.

#include "cases/case.hpp"
#include "results/provenance.hpp"

#include <vector>

namespace asperity::app {

using results::RunClock;

/// @param methods  that are run: deal.II is named only if it is used
results::Provenance
provenance_at_start(const cases::Case& rough_case, int threads,
                    const std::vector<cases::MethodSpec>& methods);

} // namespace asperity::app
