// Tests of blocks with layers, an inclusion and a variation of the moduli on
// meshes that follow the contact (fem/adaptive): the results of blocks that
// have the finest cells everywhere.
#include "meshes/layers/halvable_layers.hpp"
#include "surfaces/maps/exact_shapes.hpp"
#include "tests/fem/adaptive_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace asperity::fem::adaptive_materials_test {

/// The adaptive block, with two halvings, and the block of finest cubes.
struct Pair {
  BlockProblem adaptive, cubes;
};

Pair pair_of(const Grid& grid, const ModuliField& moduli) {
  constexpr int halvings = 2;
  const Grid cells{grid.points_x / 2, grid.points_y / 2, length, length};
  const Grid coarse{cells.points_x >> halvings, cells.points_y >> halvings,
                    length, length};
  const std::vector<double> interfaces = moduli.interfaces();
  BlockProblem adaptive{
      .grid = grid,
      .mesh = meshes::layered_mesh(
          coarse, meshes::halvable_layers(coarse.spacing_x(), halvings,
                                          interfaces, length)),
      .degree = 2,
      .moduli = moduli,
      .adaptive = AdaptiveMesh{halvings}};
  BlockProblem cubes = adaptive;
  cubes.mesh = meshes::layered_mesh(
      cells, meshes::halvable_layers(cells.spacing_x(), 0, interfaces, length));
  cubes.adaptive.reset();
  return {adaptive, cubes};
}

struct Compared {
  BlockSolution adaptive, cubes;
  double share = 0.0; ///< unknowns of the adaptive block over the other's
};

Compared compared(const Pair& pair, const std::vector<double>& heights,
                  double reduced_pressure) {
  const mechanics::LoadTarget load = pressed(reduced_pressure);
  const BlockContact contact{ContactLaw::hard, 1.0, 1e-8, 400};
  const auto adaptive = make_adaptive_block(pair.adaptive);
  const auto cubes = make_full_block(pair.cubes);
  Compared found{adaptive->solve(heights, load, contact),
                 cubes->solve(heights, load, contact)};
  EXPECT_TRUE(found.adaptive.converged) << found.adaptive.note;
  EXPECT_TRUE(found.cubes.converged) << found.cubes.note;
  found.share = static_cast<double>(adaptive->unknowns()) /
                static_cast<double>(cubes->unknowns());
  return found;
}

/// The mean difference of pressures over their mean.
double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double apart = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    apart += std::abs(a[i] - b[i]);
    sum += std::abs(b[i]);
  }
  return apart / sum;
}

/// Largest accepted differences and share of the unknowns, [1].
struct Bounds {
  double pressure = 0.0; ///< mean difference over the mean
  double gap = 0.0;      ///< of the mean gap, relative
  double unknowns = 0.0;
};

void expect_within(const Bounds& bounds, const Compared& found) {
  EXPECT_LT(difference(found.adaptive.pressure, found.cubes.pressure),
            bounds.pressure);
  EXPECT_LT(share(found.adaptive.mean_gap, found.cubes.mean_gap), bounds.gap);
  EXPECT_LT(found.share, bounds.unknowns);
}

const Grid grid{32, 32, length, length};

// Twice what was measured, rounded: under a sphere the pressure differs by 0.14
// %, the mean gap by 0.28 %, with 0.11 of the unknowns. Coarsest cubes, which
// the interface crosses, are wrong by 22 % and 4.2 %.
TEST(AdaptiveMaterials, KeepACoating) {
  ModuliField coated(moduli(body));
  coated.add_layer(0.1 * length, moduli({10.0 * soft_modulus, 0.2}));

  expect_within({0.003, 0.006, 0.2},
                compared(pair_of(grid, coated),
                         surfaces::paraboloid(grid, 5.0 * length).heights,
                         2e-3));
}

// Measured: 2.1 %, 0.32 %, 0.17.
TEST(AdaptiveMaterials, KeepANearlyIncompressibleCoating) {
  ModuliField coated(moduli(body));
  coated.add_layer(0.1 * length, moduli({0.3 * soft_modulus, 0.49}));

  expect_within({0.04, 0.006, 0.3}, compared(pair_of(grid, coated),
                                             self_affine_heights(grid), 0.001));
}

// Measured: 0.009 %, 0.25 %, 0.20.
TEST(AdaptiveMaterials, KeepAnInclusion) {
  ModuliField ball(moduli(body));
  ball.set_sphere({0.5 * length, 0.5 * length, 0.3 * length}, 0.15 * length,
                  moduli({20.0 * soft_modulus, 0.3}));

  expect_within({0.0005, 0.005, 0.3},
                compared(pair_of(grid, ball),
                         surfaces::paraboloid(grid, 5.0 * length).heights,
                         9e-4));
}

// Measured: less than 0.001 %, 0.21 %, 0.68; without regard to the moduli 0.62
// %, 0.31 %.
TEST(AdaptiveMaterials, KeepASteepGradient) {
  ModuliField graded(moduli(body));
  graded.set_factor([](const meshes::Place& place) {
    return std::exp(8.0 * place[2] / length);
  });

  expect_within({0.0005, 0.004, 0.8},
                compared(pair_of(grid, graded),
                         surfaces::paraboloid(grid, 5.0 * length).heights,
                         4e-4));
}

// Measured: 0.42 %, 0.30 %, 0.18; without regard to the moduli 2.7 %, 0.78 %.
TEST(AdaptiveMaterials, KeepRandomCubes) {
  ModuliField cubes(moduli(body));
  cubes.set_factor(random_cubes(0.9, 3, 0.125 * length), 0.125 * length);

  expect_within({0.008, 0.006, 0.3},
                compared(pair_of(grid, cubes),
                         surfaces::paraboloid(grid, 5.0 * length).heights,
                         4e-4));
}

} // namespace asperity::fem::adaptive_materials_test
