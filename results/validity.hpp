#pragma once

// Validates the numbers of a result. Numbers that no solution can have are
// rejected, whichever program wrote the file.

#include "results/types/result.hpp"

namespace asperity::results {

/// Checks the following conditions. Every number of a curve lies within the
/// range of its column (curve_columns.hpp); mean gap and nominal pressure are
/// finite in each converged step; no step occurs twice. Maps and heights are
/// finite; the parameters of a surface are finite or missing, and not negative
/// where they must not be. Columns of tables lie in the range of the curve
/// column of the same name, where NaN and infinity are allowed. E* is finite
/// and > 0. What follows from saved maps is what they say, to 1e-4: the numbers
/// of a surface by its heights (height_numbers.hpp), the nominal pressure of
/// fields by their row, and, for half-spaces and submissions, nominal pressure
/// and mean gap of a converged row by the means of its maps.
///
/// @throws input::InputError  "file: /methods/fem/0/curve/mean_gap, step 3 =
///                            nan, but must be finite [m]", with one line for
///                            each of the first ten errors
void require_valid(const Result& result);

} // namespace asperity::results
