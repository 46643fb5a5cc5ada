#pragma once

// Inside results/ only: the names of docs/results.md that writer and reader
// must agree on.

#include <string>

namespace asperity::results::layout {

constexpr const char* file_name = "result.h5";
constexpr const char* format = "asperity-result";
constexpr int format_version = 1;
constexpr const char* own_surface = "surface"; ///< beside "curve"
constexpr const char* tables = "tables";
constexpr const char* skipped = "skipped";
inline const std::string input = "input "; ///< before a key, in provenance
constexpr const char* journal = "journal"; ///< which journal is this file's
constexpr const char* journal_folded = "journal_folded"; ///< changes in it
constexpr const char* column_place = "order"; ///< of a column, 0, 1, ...

/// A case has as many realisations at most.
constexpr int most_realizations = 1000;

/// Groups whose number is beyond this are taken for something else.
constexpr int highest_index = 1'000'000;

} // namespace asperity::results::layout
