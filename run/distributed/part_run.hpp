#pragma once

// Runs one part of a case or of a sweep, and keeps what an earlier run of this
// part has computed.

#include "run/arguments/named_cases.hpp"
#include "run/distributed/part_record.hpp"
#include "run/exit_code.hpp"
#include "run/plan/run_options.hpp"

#include <filesystem>

namespace asperity::run {

/// Runs the realisations of a part into options.folder, that of the part.
/// @param options  its realisations, reference and `resume` are not read
ExitCode run_part_of_case(const ReadCase& read, const PartRecord& record,
                          RunOptions options);

/// Runs the points of a part.
/// @param folder   of the whole run
/// @param options  only methods, threads and cache are read
ExitCode run_part_of_sweep(const NamedSweep& named, const PartRecord& record,
                           const std::filesystem::path& folder,
                           const RunOptions& options);

} // namespace asperity::run
