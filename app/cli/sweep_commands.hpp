#pragma once

// What the commands run, check and report do with a sweep.

#include "app/asked/asked_cases.hpp"
#include "app/cli/checks.hpp"
#include "app/cli/commands.hpp"

#include <filesystem>
#include <string>

namespace asperity::app {

/// Returns true for a folder with the results of a sweep.
bool is_sweep_folder(const std::filesystem::path& folder);

/// Prints the points of a sweep with their predicted cost.
void print_sweep_plan(const AskedSweep& asked, const RunCommand& command);

/// Runs a sweep into a folder, writes its report and prints the expectations
/// that are not met.
///
/// @throws input::InputError  --target-error, which is about one case;
///                            otherwise as run_sweep()
ExitCode run_asked_sweep(const AskedSweep& asked, const RunCommand& command,
                         const std::filesystem::path& folder);

/// Writes sweep.json and the report of a sweep whose points are all complete,
/// and prints the expectations that are not met.
///
/// @param asked      its points have been computed with its overrides
/// @param no_report  writes sweep.json only, and judges whether all load steps
///                   have converged
ExitCode merge_asked_sweep(const AskedSweep& asked,
                           const std::filesystem::path& folder, bool no_report,
                           bool has_pdf);

/// Rewrites the report of a sweep.
///
/// @param out  folder of the report; empty: that of the sweep
ExitCode report_sweep(const std::filesystem::path& folder,
                      const std::string& out,
                      const reports::ReportExtras& extras);

/// Adds the summaries of all points of a sweep to what --json prints.
void add_sweep_answer(JsonAnswer& answer, const std::filesystem::path& folder,
                      ExitCode exit_code);

/// Checks the expectations of all points of a sweep that has run, or runs it
/// into a folder first.
void check_sweep_folder(const std::filesystem::path& folder, Checks& checks);
void check_asked_sweep(const AskedSweep& asked, const RunCommand& command,
                       const std::filesystem::path& folder, Checks& checks);

} // namespace asperity::app
