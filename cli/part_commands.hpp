#pragma once

// The commands that distribute one run over many machines: `run --part`,
// `merge` and `plan`.

#include "cli/command_parts.hpp"
#include "cli/commands.hpp"
#include "methods/cache/cache.hpp"
#include "run/arguments/named_cases.hpp"

#include <string>
#include <vector>

namespace asperity::cli {

struct MergeCommand {
  std::string folder; ///< of the run, with its parts
  bool no_report = false;
  bool has_pdf = false; ///< also print the report
};

/// Runs the share command.part of a case or a sweep. What an earlier run of
/// this part has computed is kept.
/// @throws input::InputError  a collection or several cases, or a part that the
///                            case does not have
run::ExitCode run_part(const std::vector<run::NamedCases>& named,
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

/// Joins the parts of a run and writes its report.
/// @throws input::InputError  there are none, or they lack something
run::ExitCode merge_parts(const MergeCommand& command);

struct PlanCommand {
  RunCommand run; ///< of which nothing is run
  bool is_for_slurm = false;
  int n_parts = 0;       ///< 0: one per realisation or point
  std::string time = {}; ///< limit of a task; empty: that of the partition
};

/// Prints the plan of a run, or writes the scripts by which Slurm computes it.
/// @throws input::InputError  as run_part() and write_slurm_scripts(); a wrong
///                            time
run::ExitCode plan_run(const PlanCommand& command);

/// What the command line says of these commands.
struct PartCommands {
  MergeCommand merge;
  PlanCommand plan;
};

/// @param commands, output, action  must outlive the parsing of the command
///                                  line
void add_part_commands(CLI::App& program, PartCommands& commands,
                       run::OutputOptions& output, Action& action);

} // namespace asperity::cli
