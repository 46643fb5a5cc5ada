// Tests of a flat punch on the full block: the stiffness of an upright and the
// moment of a tilted one, against the solutions for a half-space.
#include "fem/block/full_block.hpp"
#include "surfaces/maps/exact_shapes.hpp"
#include "theory/exact/hertz.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/fem/blocks.hpp"

namespace asperity::fem {
namespace {

constexpr double length = 1e-3;         // m, side and depth
constexpr double radius = 0.2 * length; // m, of the punch
constexpr double poisson = 0.3;
constexpr double tilt = 1e-4;
const double modulus = soft_modulus / (1.0 - poisson * poisson);
const double load = 2.0 * modulus * radius * 2e-3 * radius; // N

struct Pressed {
  BlockSolution solution;
  ContactStiffness stiffness;
  double moment = 0.0; ///< of the pressure about the middle [N m]
};

Pressed pressed(int points, double slope) {
  const Grid grid{points, points, length, length};
  const auto block = make_full_block(
      grid, 2,
      homogeneous_block(
          meshes::graded_layers(2 * grid.spacing_x(), 1.2, length),
          soft_modulus, poisson, mechanics::FarBoundary::clamped));
  const surfaces::HeightMap map =
      surfaces::flat_punch(grid, radius, 0.1 * radius, slope);
  Pressed result;
  result.solution = block->solve(
      map.heights,
      {mechanics::Control::nominal_pressure, load / (length * length)},
      {mechanics::ContactLaw::hard, 1e3 * modulus / grid.spacing_x(), 1e-8,
       100});
  EXPECT_TRUE(result.solution.converged);
  result.stiffness = block->stiffness();
  const double area = length * length / static_cast<double>(grid.size());
  for (int iy = 0; iy < points; ++iy)
    for (int ix = 0; ix < points; ++ix) {
      const std::size_t i = grid.index(ix, iy);
      result.moment += area * block->nodal_weights()[i] *
                       result.solution.pressure[i] * (ix - points / 2) *
                       grid.spacing_x();
    }
  return result;
}

/// The pressure at the edge is singular, and the nodes end up to half a spacing
/// inside of it: errors of first order in h/a. Measured with 32 and 64 points:
/// 0.32 and 0.47 for the stiffness, 0.60 and 0.66 for the moment.
double edge_error(int points) {
  return 0.7 * length / points / radius;
}

// k_n = 2 E* a (Boussinesq), with the uniform strain of the block and the
// displacement by the periodic images.
TEST(FlatPunch, HasTheStiffnessOfAHalfSpace) {
  const double oedometric = soft_modulus * (1.0 - poisson) /
                            ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  for (const int points : {32, 64}) {
    const double found = pressed(points, 0.0).stiffness.normal;
    const double compliance =
        1.0 / found - 1.0 / (oedometric * length) +
        theory::square_array_constant() / (std::numbers::pi * modulus * length);

    EXPECT_NEAR(compliance * 2.0 * modulus * radius, 1.0, edge_error(points));
  }
}

// M = (4/3) E* a^3 theta, from k = 8 G a^3/(3 (1 - nu)).
TEST(FlatPunch, HasTheMomentOfAHalfSpace) {
  for (const int points : {32, 64}) {
    const double moment = pressed(points, tilt).moment;

    EXPECT_NEAR(moment / (4.0 / 3.0 * modulus * std::pow(radius, 3) * tilt),
                1.0, edge_error(points));
  }
}

} // namespace
} // namespace asperity::fem
