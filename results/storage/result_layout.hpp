#pragma once

// This internal header of results/ defines the names of
// docs/reference/results.md that the writer and the reader share.

#include <string>

namespace asperity::results::layout {

constexpr const char* file_name = "result.h5";
constexpr const char* format = "asperity-result";
constexpr int format_version = 1;
constexpr const char* own_surface = "surface"; ///< beside "curve"
constexpr const char* tables = "tables";
constexpr const char* skipped = "skipped";
inline const std::string input = "input "; ///< prefix of a key in provenance
constexpr const char* journal = "journal"; ///< identity of the file's journal
constexpr const char* journal_folded = "journal_folded"; ///< number of changes
                                                         ///< in the file
constexpr const char* column_place = "order"; ///< index of a column: 0, 1, ...

/// Maximum number of realisations of a case.
constexpr int most_realizations = 1000;

/// Groups with an index above this limit are not regarded as steps or
/// realisations.
constexpr int highest_index = 1'000'000;

} // namespace asperity::results::layout
