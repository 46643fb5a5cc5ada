#pragma once

// Writes the report on a collection of cases that test the claims of one paper:
// all published numbers with their verdicts in one table, followed by one
// section per part. It owns the assembly of parts into one page; the layout is
// paper.html.mustache.

#include "reports/figures/series.hpp"
#include "reports/pages/report.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Suffix of the title of a case that ran with the settings of its quick.set;
/// the page reports it.
inline constexpr const char* quick_mark = " (quick)";

/// A part that has run. Its README.md is read by paragraphs: "**Claim.** ..."
/// and "**What does not come out.** ..." are shown.
struct PaperPart {
  std::string name;                 ///< name of its folder, "pressures-atoms"
  std::filesystem::path folder;     ///< folder of its result and its own report
  std::string readme;               ///< text of README.md
  std::vector<std::string> figures; ///< to be shown, by their file names
                                    ///< without ending
  ReportEntry entry;
};

/// Returns the section of a part. Parts whose names differ only by a number at
/// the end, such as "finite-size-2", share one section, whose figures contain
/// all of them. "finite-size-2" gives "finite-size"; a name without such an
/// ending is returned unchanged.
std::string section_of(const std::string& part_name);

/// Writes folder/report.html: the heading and first paragraphs of `readme`, the
/// table of all lines of the parts' reference.csv with the computed value of
/// each method, and the sections. Figures of a single part are those that its
/// own report drew; those of several parts are drawn into
/// folder/figures/<section>. The table is also written to folder/paper.json for
/// use by programs; its format is described in docs/reference/results.md.
///
/// @param gnuplot  name or path of the program
/// @return         the figures that could not be drawn, "name: why"
/// @throws std::system_error  the folder cannot be written
std::vector<std::string>
write_paper_report(std::span<const PaperPart> parts, const std::string& readme,
                   const std::filesystem::path& folder,
                   const ReportExtras& extras = {},
                   const std::string& gnuplot = "gnuplot");

} // namespace asperity::reports
