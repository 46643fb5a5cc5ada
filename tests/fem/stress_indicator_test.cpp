// Tests of fem/solution/stress_indicator.hpp: an exact stress has no error, and
// cells of different materials are compared where their moduli differ little.
#include "fem/solution/stress_indicator.hpp"
#include "tests/fem/changing_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace asperity::fem::stress_indicator_test {

// A uniform strain in two materials has a step of the stress between
// them, which is no error, not even if a solver left the displacement inexact
// by 1e-6; a strain that varies along a cell has one.
TEST(StressIndicator, IsZeroForASteppedStress) {
  BlockProblem problem = problem_of(1, mechanics::BlockSides::free);
  LayeredBlock layers;
  for (const double modulus : {3.0 * soft_modulus, soft_modulus})
    layers.layers.push_back(elastic_layer(0.5 * side, modulus, 0.3));
  problem.moduli = ModuliField(layers);
  const BlockSystem system(problem);
  const auto largest = [&](const Field& field) {
    const auto indicator =
        stress_indicator(system, vertical_displacement(system.space(), field));
    return *std::max_element(indicator.begin(), indicator.end());
  };

  // Both vanish at the clamped far boundary.
  const std::vector<double> noise = random_field(1000, 5);
  EXPECT_EQ(largest([&](const dealii::Point<3>& p) {
              const std::size_t i = std::hash<double>()(p[0] + 7.0 * p[1]);
              return (1e-3 + 1e-9 * noise[i % noise.size()]) *
                     (p[2] < 0.5 * side ? 2.0 * p[2] - 1.5 * side
                                        : p[2] - side);
            }),
            0.0);
  EXPECT_GT(largest([](const dealii::Point<3>& p) {
              return 1e-3 * (p[2] * p[2] / side - side);
            }),
            0.0);
}

// Where E varies smoothly, every cell is another material. The indicator must
// still compare a cell with its neighbours: of one displacement it is that of
// the uniform block, with the modulus of the cell, to roundoff. Averages of
// single cells, ratio 1, miss all of it, because first-order cells have no
// curvature in them.
TEST(StressIndicator, ComparesCellsWhoseModuliDifferLittle) {
  const BlockProblem uniform = problem_of(1, mechanics::BlockSides::free);
  BlockProblem varied = uniform;
  const auto factor = [](const meshes::Place& place) {
    return 1.0 + 0.3 * place[2] / side;
  };
  varied.moduli.set_factor(factor);
  const auto indicators = [&](const BlockProblem& problem, double ratio) {
    const BlockSystem system(problem);
    const auto displacement =
        vertical_displacement(system.space(), [](const dealii::Point<3>& p) {
          return 1e-3 * (p[2] * p[2] * p[2] / (side * side) - side);
        });
    return std::pair{mesh_of(problem),
                     stress_indicator(system, displacement, ratio)};
  };
  const auto [mesh, expected] = indicators(uniform, 1.0);
  const std::vector<double> found = indicators(varied, 1.25).second;
  const std::vector<double> alone = indicators(varied, 1.0).second;
  for (const auto& cell : mesh->active_cell_iterators()) {
    if (!cell->is_locally_owned())
      continue;
    const auto i = cell->active_cell_index();
    const dealii::Point<3> centre = cell->center();
    const double root = std::sqrt(factor({centre[0], centre[1], centre[2]}));
    EXPECT_NEAR(found[i], root * expected[i], 1e-10 * expected[i]);
    EXPECT_LT(alone[i], 1e-6 * found[i]);
  }
}

} // namespace asperity::fem::stress_indicator_test
