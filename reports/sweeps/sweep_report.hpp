#pragma once

// Writes the report on a sweep: sweep.json, sweep.csv, report.html, its figures
// and, on request, report.pdf and journal/.

#include "reports/pages/report.hpp"
#include "reports/sweeps/swept_results.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity::reports {

struct SweepReport {
  SweptResults results;
  std::vector<std::string> undrawn; ///< figures that could not be drawn, "name:
                                    ///< why"
  /// Of samples that share their loads: area and mean gap at each, as text.
  std::string answer = {};
};

/// Reads the results of all points and writes out/sweep.csv, for samples that
/// share their loads loads.csv, report.html and figures/, and sweep.json beside
/// the results. Points without a result are listed as such.
///
/// @param folder      that of the sweep, with the results below points/
/// @param is_trusted  as for read_swept_results()
/// @param gnuplot     name or path of the program
/// @throws std::system_error  the folder cannot be written
SweepReport write_sweep_report(const SweepRecord& record,
                               const std::filesystem::path& folder,
                               const std::filesystem::path& out,
                               bool is_trusted, const ReportExtras& extras = {},
                               const std::string& gnuplot = "gnuplot");

} // namespace asperity::reports
