#pragma once

// The files and the text that follow from a result: tables, summary, report,
// and the answer that --json prints.

#include "reports/analysis/summary.hpp"
#include "run/exit_code.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::run {

/// Returns whether a path is a result file or a folder with one.
bool is_result(const std::filesystem::path& path);

/// Summarises a result and prints its warnings.
reports::Summary summary_of(const results::Result& result);

/// Writes all output files besides result.h5, tables, summary and report, and
/// prints the warnings.
/// @param has_pdf  also print the report to report.pdf
/// @param has_run  this process has run the case, and told warnings before
reports::Summary write_outputs(const std::filesystem::path& folder,
                               bool has_pdf, bool has_run);

/// Prints which figures of a report could not be drawn, as errors.
void print_undrawn(const std::vector<std::string>& figures);

/// Collects what `run --json` and `check --json` print.
class JsonAnswer {
public:
  /// @param format  name of the format: "asperity-run"
  explicit JsonAnswer(std::string format) : format_(std::move(format)) {}

  /// @param folder   of the result
  /// @param summary  as in summary.json; null: nothing was summarised
  /// @param problem  why there is no summary; may be empty
  void add(const std::string& name, const std::filesystem::path& folder,
           ExitCode exit_code, const reports::Summary* summary,
           const std::string& problem = "");

  /// Prints the answer if the command has the option --json.
  void print(ExitCode exit_code) const;

private:
  std::string format_;
  std::vector<std::string> entries_; ///< as JSON
};

} // namespace asperity::run
