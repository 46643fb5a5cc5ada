#pragma once

// The flux through the gap of saved maps, for [flow] of a case.

#include "run/method_job.hpp"

#include <span>

namespace asperity::run {

/// Records for each method with saved maps the table flow_map_table() of the
/// heaviest one that is not sealed. What cannot be computed is recorded in the
/// tally and does not end the run.
/// @param run  on all ranks that solve the case together
void record_flow_maps(const RunContext& run,
                      std::span<const cases::MethodSpec> methods);

} // namespace asperity::run
