#pragma once

// Collects the provenance of one run: program, machine and options.

#include "cases/types/case.hpp"
#include "results/provenance.hpp"

namespace asperity::app {

using results::RunClock;

results::Provenance provenance_at_start(const cases::Case& contact_case,
                                        int threads);

/// Returns the versions of the finite-element libraries. The call loads them,
/// so it is made only if they were used.
results::Provenance provenance_of_fem();

} // namespace asperity::app
