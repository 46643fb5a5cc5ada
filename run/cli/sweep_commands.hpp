#pragma once

// What the commands run, check and report do with a sweep.

#include "run/arguments/named_cases.hpp"
#include "run/cli/checks.hpp"
#include "run/cli/run_command.hpp"
#include "run/sweeps/sweep_run.hpp"

#include <filesystem>
#include <string>

namespace asperity::cli {

/// Returns true for a folder with the results of a sweep.
bool is_sweep_folder(const std::filesystem::path& folder);

/// Returns the options by which a command runs the points of a sweep into a
/// folder. They refer to `named`.
run::SweepRunOptions options_of(const run::NamedSweep& named,
                                const std::filesystem::path& folder,
                                const RunCommand& command);

/// Prints the points of a sweep with what they need.
void print_sweep_plan(const run::NamedSweep& named, const RunCommand& command);

/// Runs a sweep into a folder, writes its report and prints the expectations
/// that are not met.
///
/// @throws input::InputError  --target-error, which is about one case;
///                            otherwise as run_sweep()
run::ExitCode run_named_sweep(const run::NamedSweep& named,
                              const RunCommand& command,
                              const std::filesystem::path& folder);

/// Writes the report of a sweep whose points parts have computed, and prints
/// the expectations that are not met.
///
/// @param no_report  judges only whether all load steps have converged
/// @throws input::InputError  points that are missing or incomplete
run::ExitCode merge_sweep(const std::filesystem::path& folder, bool no_report,
                          bool has_pdf);

/// Rewrites the report of a sweep.
///
/// @param out  folder of the report; empty: that of the sweep
run::ExitCode report_sweep(const std::filesystem::path& folder,
                           const std::string& out,
                           const reports::ReportExtras& extras);

/// Adds the summaries of all points of a sweep to what --json prints.
void add_sweep_answer(run::JsonAnswer& answer,
                      const std::filesystem::path& folder,
                      run::ExitCode exit_code);

/// Checks the expectations of all points of a sweep that has run, or runs it
/// into a folder first.
void check_sweep_folder(const std::filesystem::path& folder, Checks& checks);
void check_named_sweep(const run::NamedSweep& named, const RunCommand& command,
                       const std::filesystem::path& folder, Checks& checks);

} // namespace asperity::cli
