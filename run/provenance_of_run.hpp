#pragma once

// Collects the provenance of one run: program, machine and options.

#include "input/types/case.hpp"
#include "results/provenance.hpp"
#include "surfaces/measured_map.hpp"

#include <optional>

namespace asperity::run {

using results::RunClock;

/// @param found  what ranks have found of a map whose rows they read; empty:
///               this process reads the map
results::Provenance
provenance_at_start(const cases::Case& contact_case, int threads,
                    const std::optional<surfaces::MeasuredMap>& found = {});

/// Returns the versions of the finite-element libraries. The call loads them,
/// so it is made only if they were used.
results::Provenance provenance_of_fem();

} // namespace asperity::run
