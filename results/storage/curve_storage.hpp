#pragma once

// This internal header of results/ stores a curve as a group of columns.

#include "results/storage/hdf5_file.hpp"
#include "results/types/result.hpp"

#include <span>
#include <vector>

namespace asperity::results {

/// Adds rows to every column of the group `curve`. If a file of an earlier
/// version of the program lacks a column, its values in the earlier rows are
/// NaN (counts: 0).
void append_points(Hdf5Group& curve, std::span<const CurvePoint> points);

/// Returns the rows, sorted by step.
/// @throws input::InputError  nominal_pressure or mean_gap is missing, or the
///                            columns differ in length
std::vector<CurvePoint> read_points(const Hdf5Group& curve);

/// Puts the rows, which are stored as they were written, into the order of
/// their steps, and computes each contact stiffness that is NaN by finite
/// differences.
void complete_rows(Hdf5Group& curve);

} // namespace asperity::results
