#pragma once

// Reads a result file, written by this or another program in the same layout
// (docs/reference/results.md), into a Result.

#include "results/types/result.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace asperity::results {

/// Returns the file of a result.
/// @param path  the file, or the folder that contains result.h5
std::filesystem::path file_of_result(const std::filesystem::path& path);

/// Reads and validates a result.
/// @param path  the file, or the folder that contains result.h5
/// @return  the complete contents. A missing number is NaN (counts: 0), a
///          missing step is the index of its row, and a missing status is
///          converged. A missing or NaN contact stiffness is computed from the
///          curve by finite differences. Rows are sorted by step.
/// @param left  maps that are not read into memory. They are read from the file
///              at this path when they are needed, so that it must stay
/// @throws input::InputError  "file: ..." naming the group, dataset or
///                            attribute that is missing, of the wrong kind or
///                            outside its range (validity.hpp)
Result read_result(const std::filesystem::path& path,
                   MapsInFile left = MapsInFile::none);

/// The steps of each (method, realization) that a result contains.
using StepsDone = std::map<std::pair<std::string, int>, std::set<int>>;

StepsDone steps_done(const Result& result);

} // namespace asperity::results
