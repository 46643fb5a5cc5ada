#pragma once

// Inside results/ only: may a run go on with this result?

#include "results/types/result.hpp"

namespace asperity::results {

struct CaseInfo;

/// @throws cases::CaseError  the result was computed from another case, other
///                           input files or by another program; names every
///                           difference
void require_same_case(const Result& old, const CaseInfo& info);

} // namespace asperity::results
