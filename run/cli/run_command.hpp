#pragma once

// The options of `asperity run`, and what it shares with the other commands
// that compute cases or write reports.

#include "reports/pages/report.hpp"
#include "run/arguments/named_cases.hpp"
#include "run/cli/command_line.hpp"
#include "run/plan/run_options.hpp"
#include "run/result_outputs.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity::cli {

struct RunCommand {
  std::vector<std::string> cases; ///< files, folders or names of shipped cases,
                                  ///< or map files
  methods::AskedMethods methods;
  std::vector<std::string> overrides; ///< "key.path=value"
  std::string out; ///< empty: out/<case>; with several cases, each gets its own
                   ///< sub-folder
  bool resume = false;
  bool is_quick = false; ///< apply quick.set of each case
  int threads = 0;
  std::string target_error = {}; ///< e.g. "1%"; empty: the settings of the case
  bool no_report = false; ///< write result.h5 only, as benchmarks need it
  bool uses_cache = true;
  run::CaseOptions options = {};
  bool is_dry = false;      ///< print the plan without running anything
  bool has_pdf = false;     ///< also print the report
  std::string part = {};    ///< "3/8": only this share; empty: everything
  std::string against = {}; ///< map of the face that lies on the one map
};

/// Refuses a PDF before anything is computed.
/// @throws std::domain_error  no program prints PDF
void require_pdf_program();

/// @throws std::domain_error  no program prints PDF, or an unknown format,
///                            width or unit
reports::ReportExtras extras_of(const ReportForms& forms);

/// Returns the output folder of a case or collection of that name.
/// @param out        option --out; empty: out/<name>
/// @param n_targets  number of targets of the command; with more than one, each
///                   gets its own sub-folder of `out`
std::filesystem::path folder_of(const std::string& name, const std::string& out,
                                std::size_t n_targets);

/// Returns the output folder of one case of those that a word names.
std::filesystem::path folder_of_part(const run::NamedCases& named,
                                     const run::ReadCase& part,
                                     const std::string& out,
                                     std::size_t n_targets);

/// Reads the cases that a command asks for; several maps are one sweep.
/// @throws input::InputError  as run::read_named_cases_or_sweep(), and for maps
///                            in the output folder
std::vector<run::NamedCases> read_asked(const RunCommand& command);

/// Reads a map and the one against it with the options of maps, as `surface`
/// does, and writes the sum of their heights into the output folder, from which
/// it is pressed like any map. The case names both files with their SHA-256.
/// @throws input::InputError  as read_asked(), or a word is no map
run::NamedCases read_faces(const RunCommand& command);

/// Returns the options by which a command runs a case into a folder.
run::RunOptions options_of(const run::ReadCase& read,
                           const std::filesystem::path& folder,
                           const RunCommand& command, methods::Cache& cache);

/// Runs cases. All cases are read before the first one is run. A collection
/// gets a report on all of its parts, in out/<collection>, after they have run.
run::ExitCode run_cases(const RunCommand& command);

/// Adds the result in a folder, if there is one, to what --json prints.
void add_answer(run::JsonAnswer& answer, const std::string& name,
                const std::filesystem::path& folder, run::ExitCode exit_code);

/// The exit code of a command after some figures could not be drawn: the report
/// says so in their places, which is no success if the figures are what the
/// user has asked for.
run::ExitCode exit_of_figures(const std::vector<std::string>& undrawn,
                              bool are_asked_for);

} // namespace asperity::cli
