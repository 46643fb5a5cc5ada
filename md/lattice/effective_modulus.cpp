#include "md/lattice/effective_modulus.hpp"

#include "base/require.hpp"
#include "md/lattice/block_solver.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace asperity::md {

double effective_contact_modulus(const Crystal& crystal, int levels,
                                 int layers) {
  require_between("levels", levels, 1.0, 20.0, "1");
  const int side = 1 << (levels - 1);
  const int points =
      side * std::max(1, static_cast<int>(
                             std::lround(2.0 * std::numbers::pi / 0.1 / side)));
  const Grid strip{points, side, points * crystal.spacing,
                   side * crystal.spacing};
  const MultiscaleBlock block(crystal, {strip, levels, layers});
  const BlockSolver solver(block, {0.0, true});
  const double wavevector = 2.0 * std::numbers::pi / strip.length_x;
  const std::size_t n = strip.size();
  std::vector<double> forces(block.size());
  std::vector<double> answer(block.size());
  for (std::size_t i = 0; i < n; ++i)
    forces[2 * n + i] = std::cos(
        2.0 * std::numbers::pi *
        static_cast<double>(i % static_cast<std::size_t>(points)) / points);
  solver.solve(forces, answer);
  const double compliance = // ratio of the amplitudes of z and of the pressure
      2.0 * strip.cell_area() / static_cast<double>(n) *
      std::inner_product(forces.begin(), forces.end(), answer.begin(), 0.0);
  return 2.0 / (wavevector * compliance);
}

} // namespace asperity::md
