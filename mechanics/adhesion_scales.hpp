#pragma once

// The node spacing by which a grid resolves the range of an adhesion.

#include "base/grid.hpp"
#include "mechanics/quantity.hpp"

#include <algorithm>

namespace asperity::mechanics {

/// The scales of a law with adhesion on a grid: h is the larger of the two
/// spacings, because the tension at the edge of a contact must be resolved in
/// every direction.
/// @param scales  with h along x
inline Scales adhesion_scales(Scales scales, const Grid& grid) {
  scales.spacing = std::max(grid.spacing_x(), grid.spacing_y());
  return scales;
}

} // namespace asperity::mechanics
