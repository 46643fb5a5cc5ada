#pragma once

// The report on a collection of cases once its parts have run, from the files
// they left.

#include "app/run/case_library.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::app {

/// A part of a collection that has a result.
struct RunPart {
  FoundCase part;
  std::filesystem::path folder; ///< of its result
};

/// Writes folder/report.html and what stands beside it. Nothing if no part ran.
void write_collection_report(const FoundCases& collection,
                             const std::vector<RunPart>& parts,
                             const std::filesystem::path& folder);

} // namespace asperity::app
