#pragma once

// Draws the figures of a surface report: map, heights, spectrum, dependence on
// scale and predicted contact.

#include "reports/figures/gnuplot.hpp"
#include "reports/surface/surface_report.hpp"

#include <vector>

namespace asperity::reports {

/// Figures of one map: topography, heights, map-spectrum, scale-slope,
/// scale-curvature.
std::vector<Figure> figures_of(const surfaces::MapAnalysis& map);

/// Figures of one line scan: profile, profile-spectrum.
std::vector<Figure> figures_of(const surfaces::LineAnalysis& scan);

/// Predicted separation and contact area: predicted-separation,
/// predicted-area and, of a map, predicted-cut-off.
std::vector<Figure> contact_figures(const PredictedContact& contact);

/// C(q) of a map with its confidence band, its limits and the fitted model.
Figure map_spectrum_figure(const surfaces::MapAnalysis& map);

} // namespace asperity::reports
