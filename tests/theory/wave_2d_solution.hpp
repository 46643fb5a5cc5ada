#pragma once

// The egg-box contact by the project's own solver, on the square cell of one
// crest, from which the table of theory/exact/wave_2d_table.hpp is computed. A
// different method verifies it: wave_2d_elements.hpp.

#include "tests/theory/numerical_contact.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace asperity::theory {

/// Means over the cell, in units of the amplitude D and of p*.
struct Wave2dSolution {
  double area_fraction =
      0.0;               ///< counted nodes: too large by 0.1 perimeter/points
  double mean_gap = 0.0; ///< over D
  double energy = 0.0;   ///< over D p*
};

/// Solves at ascending p/p*, on several grids that differ in the position of
/// the crest between the nodes (offsets of low discrepancy), and takes the
/// mean.
inline std::vector<Wave2dSolution>
solve_wave_2d(const std::vector<double>& reduced_pressures, int points,
              int n_offsets) {
  using std::numbers::pi;
  // The cell lambda/sqrt2 wide, turned by 45 degrees, has
  // h = (D/2) [cos(2 pi x) + cos(2 pi y)]; p* = pi E* D per its width.
  const Grid grid{points, points, 1.0, 1.0};
  std::vector<Wave2dSolution> means(reduced_pressures.size());
  for (int offset = 0; offset < n_offsets; ++offset) {
    const double shift_x = std::fmod(0.5 + offset * 0.7548776662466927, 1.0);
    const double shift_y = std::fmod(0.5 + offset * 0.5698402909980532, 1.0);
    std::vector<double> heights(grid.size());
    for (int iy = 0; iy < points; ++iy)
      for (int ix = 0; ix < points; ++ix)
        heights[grid.index(ix, iy)] =
            0.5 * (std::cos(2.0 * pi * (ix + shift_x) / points) +
                   std::cos(2.0 * pi * (iy + shift_y) / points));
    contact::LoadSequence sequence = halfspace_contact(grid, heights, 1.0 / pi);
    for (std::size_t k = 0; k < means.size(); ++k) {
      const contact::ContactSolution solution = sequence.solve(
          {mechanics::Control::nominal_pressure, reduced_pressures[k]});
      const double share = 1.0 / static_cast<double>(grid.size()) / n_offsets;
      for (std::size_t i = 0; i < grid.size(); ++i) {
        means[k].area_fraction += solution.pressure[i] > 0.0 ? share : 0.0;
        means[k].energy +=
            0.5 * share * solution.pressure[i] * solution.displacement[i];
      }
      means[k].mean_gap += solution.mean_gap / n_offsets;
    }
  }
  return means;
}

/// The limit of vanishing spacing from two grids, the second twice as fine: the
/// error of a counted area is of first order; the gap is that of the finer
/// grid.
inline Wave2dSolution extrapolated(const Wave2dSolution& coarse,
                                   const Wave2dSolution& fine) {
  return {2.0 * fine.area_fraction - coarse.area_fraction, fine.mean_gap,
          fine.energy};
}

} // namespace asperity::theory
