#pragma once

// The rough surface on which meshes that follow the contact are compared with
// uniform ones, in tests and in the benchmark.

#include "base/grid.hpp"
#include "surfaces/maps/self_affine.hpp"
#include "surfaces/realization.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

namespace asperity::fem {

/// Heights [m] of a self-affine surface on a square grid: H = 0.8, eight nodes
/// on the shortest wave, rms slope 0.1.
inline std::vector<double> self_affine_heights(const Grid& grid) {
  const double unit = 2.0 * std::numbers::pi / grid.length_x;
  const surfaces::SelfAffineShape shape{0.8, 2.0 * unit, 3.0 * unit,
                                        std::max(4, grid.points_x / 8) * unit};
  return surfaces::realize(
             surfaces::SelfAffineSpectrum::with_rms_slope(shape, 0.1)
                 .isotropic(),
             grid, {7, 0})
      .heights;
}

} // namespace asperity::fem
