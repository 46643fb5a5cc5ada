#pragma once

// Draws the figures of a report again in the formats and at the widths of
// journals.

#include "reports/figures/gnuplot.hpp"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace asperity::reports {

struct JournalFormat {
  std::set<std::string> endings; ///< of "pdf", "svg", "png"; empty: no figures
  double width = 86e-3;          ///< of a single column [m]
  std::string units = {}; ///< "physical" or "reduced"; empty: as in the report
};

/// Reads "pdf,svg" and "86mm", "8.6 cm" or "3.4 in".
/// @throws std::domain_error  an unknown ending or unit, or a width outside 30
///         to 300 mm; the message names what is allowed
JournalFormat journal_format(const std::vector<std::string>& endings,
                             const std::string& width);

/// Writes a figure of the report into `folder`, with its table, its script and
/// one drawing per ending. The text has 8 points, that of legends 7, and PNG
/// 600 pixels per inch. A plot with its own axes is arranged by
/// journal_layout(), with one pair of units. A figure of several panels or
/// maps, which is wider than 700 px on the screen, gets the width of two
/// columns and the 6 mm between them.
/// @return  why an image could not be drawn; empty if all were
/// @throws std::system_error  the folder cannot be written
std::string draw_for_journal(const Figure& drawn, const JournalFormat& format,
                             const std::filesystem::path& folder,
                             const std::string& program = "gnuplot");

/// Records in the folder of journal figures what has been drawn there.
void record_drawn(const std::filesystem::path& journal);

/// Moves a folder of journal figures that somebody has edited since
/// record_drawn() to "journal.edited", or "journal.edited-2" and so on, in the
/// folder `beside`, and says so. One that nobody has edited stays.
void keep_edited(const std::filesystem::path& journal,
                 const std::filesystem::path& beside);

} // namespace asperity::reports
