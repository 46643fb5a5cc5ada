#pragma once

// This internal header of results/ stores the list of computations that a run
// skipped as a group.

#include "results/storage/hdf5_file.hpp"
#include "results/types/result.hpp"

#include <span>
#include <vector>

namespace asperity::results {

/// Writes into the empty group `group`.
void write_skipped(Hdf5Group& group, std::span<const Skipped> skipped);

/// Reads the list of skipped computations.
/// @throws input::InputError  the columns differ in length
std::vector<Skipped> read_skipped(const Hdf5Group& group);

} // namespace asperity::results
