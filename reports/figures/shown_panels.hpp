#pragma once

// Leaves out what a figure would show nothing of, such as the costs of a result
// that states no times.

#include "reports/figures/figures.hpp"

namespace asperity::reports {

/// Removes the panels whose curves have no point with a number on both axes,
/// and the figures of which no panel is left.
void leave_out_empty_panels(std::vector<Figure>& figures);

} // namespace asperity::reports
