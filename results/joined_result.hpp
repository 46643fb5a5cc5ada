#pragma once

// Joins results of one case, each of which holds some of its realisations, to
// the result of the whole case.

#include <filesystem>
#include <vector>

namespace asperity::results {

/// Writes the joined result to folder/result.h5. Curves, maps, surfaces and
/// tables are those of the parts, bit by bit. Of the facts of the provenance,
/// CPU times and counts of steps are added, wall time and peak memory are the
/// largest, the run has started with the first part and finished with the last,
/// and other facts that differ (the machine) are listed one after another. A
/// new fact, "parts", is the number of parts.
///
/// @param parts   folders of complete results; the first one holds realisation
///                0; no realisation of a method occurs twice
/// @param folder  is created if necessary; a result in it is replaced
/// @throws input::InputError  a part cannot be read, or is of another case, of
///                            other methods or inputs, or of another program
///                            than the first
/// @throws std::domain_error  there are no parts, or a step occurs twice
void join_results(const std::vector<std::filesystem::path>& parts,
                  const std::filesystem::path& folder);

} // namespace asperity::results
