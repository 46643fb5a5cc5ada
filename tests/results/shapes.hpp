#pragma once

// Pressure maps of known shapes for the tests of results/: 1 Pa in contact.

#include "base/grid.hpp"

#include <cmath>
#include <vector>

namespace asperity::results {

/// 1 Pa where is_inside(x, y) [m] of the node, else 0.
template <class IsInside>
std::vector<double> shape(const Grid& grid, IsInside is_inside) {
  std::vector<double> pressure(grid.size(), 0.0);
  for (int iy = 0; iy < grid.points_y; ++iy)
    for (int ix = 0; ix < grid.points_x; ++ix)
      if (is_inside(ix * grid.spacing_x(), iy * grid.spacing_y()))
        pressure[grid.index(ix, iy)] = 1.0;
  return pressure;
}

/// Distance of x from `centre` in a period, -length/2..length/2.
inline double periodic_distance(double x, double centre, double length) {
  return std::remainder(x - centre, length);
}

} // namespace asperity::results
