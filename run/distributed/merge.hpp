#pragma once

// Joins the parts of a run to the result that one undivided run would have
// written.

#include "run/arguments/named_cases.hpp"
#include "run/distributed/part_record.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::run {

/// All parts of one run, and the case that they compute.
struct WholeRun {
  std::vector<PartRecord> parts; ///< all of them, in the order of their numbers
  NamedCases named;              ///< one case or one sweep
};

/// Reads the parts in the folder of a run and checks that they belong together,
/// that their case file says the same as when they ran, and that each of them
/// is complete.
///
/// @throws input::InputError  there is no part; parts of different cases or
///                            numbers of parts; a case that has changed; or
///                            parts that are missing or incomplete, each with
///                            the command that computes it
WholeRun read_whole_run(const std::filesystem::path& folder);

/// Joins the results of the parts of a case to folder/result.h5, with the files
/// that their methods wrote. An older result of this name is kept as by a run.
/// Does nothing if the joined result is there already.
void merge_realizations(const WholeRun& run,
                        const std::filesystem::path& folder);

} // namespace asperity::run
