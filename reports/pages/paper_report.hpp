#pragma once

// The report on a collection of cases that test the claims of one paper: every
// published number judged in one table, then a section a part. Owns how parts
// become one page; the look is paper.html.mustache.

#include "reports/figures/series.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Ends the title of a case that ran with its quick.set: the page says so.
inline constexpr const char* quick_mark = " (quick)";

/// A part that has run. Its README.md is read by paragraphs: "**Claim.** ..."
/// and "**What does not come out.** ..." are shown.
struct PaperPart {
  std::string name;                 ///< of its folder, "pressures-atoms"
  std::filesystem::path folder;     ///< of its result and its own report
  std::string readme;               ///< text of README.md
  std::vector<std::string> figures; ///< to be shown, by their file names
                                    ///< without ending
  ReportEntry entry;
};

/// Parts whose names differ by a number at the end alone, "finite-size-2",
/// stand together: one section, with figures that hold all of them.
/// "finite-size-2" -> "finite-size"; a name without such an end as it is.
std::string section_of(const std::string& part_name);

/// Writes folder/report.html: the heading and first paragraphs of `readme`, the
/// table of every line of every part's reference.csv with ours by each method,
/// then the sections. Figures of a single part are those its own report drew;
/// those of several are drawn into folder/figures/<section>. The table is in
/// folder/paper.json too, for programs: docs/results.md says how.
///
/// @param gnuplot  name or path of the program
/// @return         the figures that could not be drawn, "name: why"
/// @throws std::system_error  the folder cannot be written
std::vector<std::string>
write_paper_report(std::span<const PaperPart> parts, const std::string& readme,
                   const std::filesystem::path& folder,
                   const std::string& gnuplot = "gnuplot");

} // namespace asperity::reports
