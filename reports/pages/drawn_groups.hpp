#pragma once

// Figures as they were drawn, and their bytes, so that another report on the
// same numbers need not draw them again.

#include "reports/figures/gnuplot.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::reports {

/// Figures that belong together under one heading; an empty heading is not
/// shown.
struct DrawnGroup {
  std::string heading;
  std::vector<DrawnFigure> figures;
};

std::string bytes_of(std::span<const DrawnGroup> groups);

/// @throws std::runtime_error  these are not bytes of bytes_of()
std::vector<DrawnGroup> drawn_groups_in(std::string_view bytes);

} // namespace asperity::reports
