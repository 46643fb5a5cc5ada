#pragma once

// Describes the outcome of a request for an error target, for the terminal and
// for the provenance of the result.

#include "bench/analysis/bench.hpp"
#include "results/types/result.hpp"

namespace asperity::bench {

/// Prints one line per quantity: "target 1 %, predicted 0.4 %, found 0.7 %:
/// met".
void print_outcome(const TargetOutcome& outcome);

/// Returns the same for the provenance of a result, including the earlier
/// attempts.
results::Provenance facts_of(const TargetOutcome& outcome);

} // namespace asperity::bench
