#pragma once

// Arranges a figure on the page of a journal: margins, legend and height, such
// that most of the figure is its plot. It is internal to this folder.

#include "reports/figures/gnuplot.hpp"

namespace asperity::reports {

/// Share of the figure that the rectangle between the axes covers at least,
/// where the width allows it.
constexpr double least_plot_share = 0.6;

struct JournalLayout {
  double height = 0.0; ///< [m]
  Figure figure;       ///< with the arrangement
};

/// Arranges a figure of this width.
///
/// A figure with one pair of axes gets fixed margins and no axes in other
/// units. The legend is below the axis, in as many columns as fit, and the
/// figure becomes higher if the plot would cover less than least_plot_share.
/// Figures of several panels or with images keep their proportions, with
/// margins for text of this size.
///
/// @param width        [m]
/// @param font_size    of labels [pt]; the legend is one point smaller
/// @param line_height  of the format's text over that of PDF and PNG [1]
JournalLayout journal_layout(const Figure& figure, double width,
                             double font_size, double line_height);

} // namespace asperity::reports
