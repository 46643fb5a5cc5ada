#pragma once

// Reads a result file, ours or a foreign one of the same layout
// (docs/results.md), into a Result.

#include "results/types/result.hpp"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace asperity::results {

/// @param path  the file, or the folder whose result.h5 it is
/// @return  everything in it. A number that is missing is NaN (counts: 0), a
///          missing step is its row, a missing status converged; a missing or
///          NaN contact stiffness is taken from the curve by differences; rows
///          come in the order of their steps.
/// @throws cases::CaseError  "file: ..." naming the group, dataset or
///          attribute that is missing, not of its kind, or outside its range
///          (validity.hpp)
Result read_result(const std::filesystem::path& path);

/// Which steps of which (method, realization) a result holds.
using StepsDone = std::map<std::pair<std::string, int>, std::set<int>>;

StepsDone steps_done(const Result& result);

} // namespace asperity::results
