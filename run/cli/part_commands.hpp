#pragma once

// Runs that are distributed over many machines: `run --part`, and by mpirun.

#include "run/arguments/named_cases.hpp"
#include "run/cli/run_command.hpp"
#include "run/methods/cache/cache.hpp"

#include <filesystem>
#include <vector>

namespace asperity::cli {

/// Runs the share command.part of a case or a sweep. What an earlier run of
/// this part has computed is kept.
/// @throws input::InputError  a collection or several cases, or a part that the
///                            case does not have
run::ExitCode run_part(const std::vector<run::NamedCases>& all,
                       const RunCommand& command, methods::Cache& cache);

/// Returns whether the members of a case or a sweep are distributed over the
/// ranks of an mpirun: there are several of both, and no method is a full 3-D
/// block, which all ranks solve together.
bool is_for_ranks(const run::NamedCases& named, const RunCommand& command);

/// Runs a case or sweep whose members the ranks share, and merges the parts.
/// @throws input::InputError  a rank whose part was not completed
run::ExitCode run_over_ranks(const run::NamedCases& named,
                             const RunCommand& command,
                             const std::filesystem::path& folder);

} // namespace asperity::cli
