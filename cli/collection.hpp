#pragma once

// Writes the report on a collection of cases from the result files of its
// parts, once these have run.

#include "run/arguments/case_library.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::cli {

/// A part of a collection that has a result.
struct RunPart {
  run::FoundCase part;
  std::filesystem::path folder; ///< folder of the result
};

/// Writes folder/report.html and the files that belong to it. Does nothing if
/// no part has run.
/// @param has_pdf  also print the report to report.pdf
void write_collection_report(const run::FoundCases& collection,
                             const std::vector<RunPart>& parts,
                             const std::filesystem::path& folder, bool has_pdf);

} // namespace asperity::cli
