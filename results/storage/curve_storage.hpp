#pragma once

// Inside results/ only: a curve as the group of columns it is in a file.

#include "results/storage/hdf5_file.hpp"
#include "results/types/result.hpp"

#include <span>
#include <vector>

namespace asperity::results {

/// Adds rows to every column of the group `curve`. A column that a file of an
/// earlier program lacks is NaN (a count: 0) in the rows before.
void append_points(Hdf5Group& curve, std::span<const CurvePoint> points);

/// The rows in the order of their steps, as they were written.
/// @throws cases::CaseError  nominal_pressure or mean_gap is missing, or the
///                           columns differ in length
std::vector<CurvePoint> read_points(const Hdf5Group& curve);

/// Fills the contact stiffness that is NaN, by differences.
void fill_stored_stiffness(Hdf5Group& curve);

} // namespace asperity::results
