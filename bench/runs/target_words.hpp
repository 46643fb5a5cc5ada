#pragma once

// What came of asking for an error, for people and for the result's facts.

#include "results/types/result.hpp"

#include "bench/analysis/bench.hpp"

namespace asperity::app {

/// A line a quantity: "promised 1 %, predicted 0.4 %, found 0.7 %: kept".
void print_outcome(const reports::TargetOutcome& outcome);

/// The same for the provenance of a result, with what was tried before.
results::Provenance facts_of(const reports::TargetOutcome& outcome);

} // namespace asperity::app
