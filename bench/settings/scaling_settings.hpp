#pragma once

// Selects the runs of a scaling study: the case on several numbers of threads
// or ranks, with the same work and with work that grows with them.

#include "bench/settings/bench_plan.hpp"
#include "cases/types/case.hpp"

#include <string>
#include <vector>

namespace asperity::bench {

struct ScalingOptions {
  std::vector<std::string> methods = {}; ///< names or kinds; empty: all
  std::vector<int> threads = {};         ///< ascending; may be empty
  std::vector<int> ranks = {};           ///< ascending; may be empty
};

/// Returns the runs. Threads share the work on the nodes: in the weak series
/// the points per side grow with the square root of the threads, on the same
/// surface. Ranks share the realisations, of which the weak series has one per
/// rank; or the block of a method with `solver = "full"`, or the rows of a
/// single realisation (is_shared_by_ranks), whose points grow.
/// The theory is left out, because it takes no time.
///
/// @throws input::InputError  a method is unknown, there is none besides the
///                            theory, or ranks have nothing to share
BenchPlan scaling_of(const cases::Case& contact_case,
                     const ScalingOptions& options);

} // namespace asperity::bench
