#pragma once

// Rejects a run that would exceed the available memory before it begins.

#include "run/plan/plan.hpp"

namespace asperity::run {

/// Returns the reason why a run does not fit into memory, such as "needs 128
/// GiB of memory, but 12 GiB are available", and possible remedies. The text is
/// empty if the run fits or if its memory cannot be predicted.
std::string refusal_of(const Plan& plan);

/// Checks that a run fits into the available memory. A measured map on its own
/// grid is not checked, because its file limits the size.
///
/// @throws input::InputError  the run does not fit
void require_memory(const cases::Case& contact_case, const RunOptions& options);

} // namespace asperity::run
