#pragma once

// The distribution of the surface's height, as Figs. 5 and 13 of the paper.

#include "reports/figures/gnuplot.hpp"
#include "reports/figures/series.hpp"

#include <optional>

namespace asperity::reports {

/// P_h of up to four realisations against h/h_rms, each in its own h_rms, with
/// the Gaussian; the bins are h_rms/5 wide and hold all heights. None if no
/// heights are in the result, or for a shape that is not rough.
std::optional<Figure> height_figure(const ReportEntry& entry);

} // namespace asperity::reports
