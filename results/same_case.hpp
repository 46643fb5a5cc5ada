#pragma once

// This internal header of results/ checks whether a run may continue an
// existing result.

#include "results/types/result.hpp"

namespace asperity::results {

struct CaseInfo;

/// Checks that the result belongs to the same case.
/// @throws input::InputError  the result was computed from another case, from
///                            other input files or by another program; the
///                            message names every difference
void require_same_case(const Result& old, const CaseInfo& info);

} // namespace asperity::results
