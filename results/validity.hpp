#pragma once

// What a result's numbers can be. Owns the refusal of those that no solution
// has, whoever wrote the file.

#include "results/types/result.hpp"

namespace asperity::results {

/// Every number of a curve within the range of its column (curve_columns.hpp),
/// mean gap and nominal pressure finite in each step that converged, no step
/// twice; maps and heights finite; the scales of a surface finite and not
/// negative; columns of tables in the range of a curve's column of that name,
/// where NaN and infinity are allowed; E* finite and > 0.
///
/// @throws cases::CaseError  "file: /methods/fem/0/curve/mean_gap, step 3 =
///         nan, but must be finite [m]", a line for each, the first ten of them
void require_valid(const Result& result);

} // namespace asperity::results
