#pragma once

// Finds out what an earlier run has left in a folder for a run of the same
// case, so that nothing is computed twice.

#include "cases/types/case.hpp"
#include "results/types/result.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace asperity::run {

enum class RunState { missing, to_resume, complete };

struct EarlierRun {
  RunState state = RunState::missing;
  std::string case_hash = {}; ///< of the result
};

/// Returns whether every load step of a result has converged.
bool all_converged(const results::Result& result);

/// Reads the result in a folder. One of another case, of other input files or
/// of another program counts as missing, as does an incomplete one whose case
/// is written differently, because the run would refuse to resume it.
///
/// @param only  the realisations that are needed; empty: all
EarlierRun earlier_run(const cases::Case& contact_case,
                       const std::vector<cases::MethodSpec>& methods,
                       const std::filesystem::path& folder,
                       const std::set<int>& only = {});

} // namespace asperity::run
