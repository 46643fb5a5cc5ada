#pragma once

// Records the tables of the studies of a case (docs/reference/results.md).

#include "run/method_job.hpp"

#include <span>

namespace asperity::run {

/// Records the tables that the theory answers. Tables that are already in the
/// file are not computed again, and cached tables are read. An interrupt takes
/// effect between two tables.
///
/// @param theory  study_theory() of the case
void run_studies(const RunContext& context, const cases::MethodSpec& theory);

/// Records the table that a study has of the heaviest saved map, of each
/// method.
void record_map_tables(const RunContext& run,
                       std::span<const cases::MethodSpec> methods);

} // namespace asperity::run
