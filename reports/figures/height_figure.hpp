#pragma once

// Plots the height distribution of the surface, as in Figs. 5 and 13 of Yang
// and Persson (2008).

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/series.hpp"

#include <optional>

namespace asperity::reports {

/// Plots P_h of up to four realisations against h/h_rms, each normalised by its
/// own h_rms, with the Gaussian for comparison. The bins are h_rms/5 wide and
/// contain all heights. Nothing is returned if the result contains no heights
/// or the shape is not rough.
std::optional<Figure> height_figure(const ReportEntry& entry);

} // namespace asperity::reports
