#pragma once

// Inside results/ only: what a run did not compute, as the group it is in a
// file.

#include "results/storage/hdf5_file.hpp"
#include "results/types/result.hpp"

#include <span>
#include <vector>

namespace asperity::results {

/// Fills the empty group `group`.
void write_skipped(Hdf5Group& group, std::span<const Skipped> skipped);

/// @throws cases::CaseError  the columns differ in length
std::vector<Skipped> read_skipped(const Hdf5Group& group);

} // namespace asperity::results
