#pragma once

// Refuses a run that would not fit into the memory there is, before it begins.

#include "app/plan/plan.hpp"

namespace asperity::app {

/// "needs 128 GiB of memory, but 12 GiB are available", and what would help;
/// empty if the run fits or its memory is not predicted.
std::string refusal_of(const Plan& plan);

/// @throws cases::CaseError  the run does not fit. A measured map on its own
///         grid is not held against it: its file has bounded it.
void require_memory(const cases::Case& rough_case, const RunOptions& options);

} // namespace asperity::app
