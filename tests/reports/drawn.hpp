#pragma once

// Draws one figure of a report alone.

#include "reports/figures/figures.hpp"

#include <span>
#include <vector>

namespace asperity::reports {

/// Nothing is returned if the figure does not apply to the result.
inline std::vector<Figure> drawn(const ReportFigure& figure,
                                 const ReportEntry& entry) {
  const std::span<const ReportEntry> entries(&entry, 1);
  const std::vector<Series> series = series_of(entries);
  const FigureData data{entries, series, figure_scales(entries)};
  return figure.applies != nullptr && !figure.applies(data)
             ? std::vector<Figure>{}
             : figure.draw(data);
}

} // namespace asperity::reports
