#pragma once

// Figures as they were drawn.

#include "reports/figures/figures.hpp"
#include "reports/figures/gnuplot.hpp"
#include "reports/figures/journal_figures.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity::reports {

/// Figures that belong together under one heading; an empty heading is not
/// shown.
struct DrawnGroup {
  std::string heading;
  std::vector<DrawnFigure> figures;
};

/// Draws all figures into folder/figures, several at a time, and again into
/// folder/journal if the format names an ending. Edited figures that were there
/// are kept, see keep_edited(). A group without figures is left out.
/// @param problems  gets the figures that could not be drawn: "name: why"
std::vector<DrawnGroup> drawn_groups_of(std::span<const FigureGroup> groups,
                                        const std::filesystem::path& folder,
                                        const std::string& gnuplot,
                                        const JournalFormat& journal,
                                        std::vector<std::string>& problems);

} // namespace asperity::reports
