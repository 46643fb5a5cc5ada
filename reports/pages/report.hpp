#pragma once

// Is the interface of the module: it takes results and writes a report folder.

#include "reports/figures/journal_figures.hpp"
#include "reports/figures/series.hpp"
#include "reports/pages/drawn_groups.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// What is written on request.
struct ReportExtras {
  bool has_pdf = false;       ///< report.pdf, printed by pdf_program()
  JournalFormat journal = {}; ///< figures for a journal, in journal/
  std::vector<std::string> labels = {}; ///< names of the results, in order;
                                        ///< empty: they follow from the results
  /// How the names of the figures to draw begin: "pressure-gap", "map"; empty:
  /// all.
  std::vector<std::string> only = {};
};

/// Writes folder/report.html, folder/figures/* (SVG, CSV and gnuplot script of
/// each figure) and, for a single result, folder/summary.json; for several,
/// folder/comparison.json and comparison.csv (agreement.hpp). Several results
/// share their curve figures; the maps of each are in a separate folder. The
/// text on methods and the literature are in methods.txt and methods.bib
/// (methods_text.hpp). A figure that cannot be drawn is listed in the report
/// and is not an error.
///
/// @param gnuplot  name or path of the program
/// @return         the figures that could not be drawn, "name: why", also
///                 "report.pdf: why"
/// @throws std::system_error  the folder cannot be written
/// @throws input::InputError  no figure has a name of extras.only
std::vector<std::string> write_report(std::span<const ReportEntry> entries,
                                      const std::filesystem::path& folder,
                                      const std::string& gnuplot = "gnuplot",
                                      const ReportExtras& extras = {});

/// Does the same from results alone: the case text that each result contains is
/// parsed again.
/// @throws input::InputError  a result's case text has mistakes
std::vector<std::string> write_report(std::span<const results::Result> results,
                                      const std::filesystem::path& folder,
                                      const std::string& gnuplot = "gnuplot",
                                      const ReportExtras& extras = {});

/// Returns the case from which a result was computed, parsed from the text in
/// the result. The `path` in messages is that of the result. A result without a
/// case text, as other codes write it, is treated as a measured surface without
/// expectations.
cases::Case case_of(const results::Result& result);

/// Returns a result with its case and its summary. Both arguments must outlive
/// it.
ReportEntry entry_of(const results::Result& result,
                     const cases::Case& contact_case);

} // namespace asperity::reports
