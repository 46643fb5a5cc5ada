#pragma once

// Describes the outcome of a request for an error target, for the terminal and
// for the provenance of the result.

#include "results/types/result.hpp"

#include "bench/analysis/bench.hpp"

namespace asperity::app {

/// Prints one line per quantity: "target 1 %, predicted 0.4 %, found 0.7 %:
/// met".
void print_outcome(const reports::TargetOutcome& outcome);

/// Returns the same for the provenance of a result, including the earlier
/// attempts.
results::Provenance facts_of(const reports::TargetOutcome& outcome);

} // namespace asperity::app
