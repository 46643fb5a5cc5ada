// Tests of fem/linear/box_grid_block.hpp: the stiffness without a matrix and
// geometric multigrid, compared with deal.II's assembled matrix and the direct
// solver. The tests also run on two and three ranks, which share the rows.
#include "fem/linear/block_solver.hpp"
#include "fem/linear/box_grid_block.hpp"
#include "tests/fem/block_vectors.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <gtest/gtest.h>

namespace asperity::fem::box_grid_block_test {

using mechanics::BlockSides;
using mechanics::FarBoundary;

constexpr double length = 1e-6; // m

enum class Material { layers, heterogeneous_cells, sphere };

struct BoxGridCase {
  int degree;
  FarBoundary far_boundary;
  BlockSides sides;
  Material material;
};

/// Boxes with unequal sides, 8 nodes and 13 rows of cells per plane, which no
/// ranks share evenly, in layers of any thickness.
BlockProblem problem_of(const BoxGridCase& own) {
  const Grid cells{8 / own.degree, 13, length, 1.2 * length};
  const Grid grid{8, 13 * own.degree, length, 1.2 * length};
  LayeredBlock layers;
  layers.far_boundary = own.far_boundary;
  const std::vector<double> thickness{0.1 * length, 0.17 * length,
                                      0.4 * length};
  for (std::size_t i = 0; i < thickness.size(); ++i)
    layers.layers.push_back(elastic_layer(
        thickness[i], soft_modulus * (1.0 + static_cast<double>(i)),
        0.1 + 0.1 * static_cast<double>(i)));
  BlockProblem problem{grid, meshes::layered_mesh(cells, thickness), own.degree,
                       ModuliField(layers)};
  problem.far_boundary = own.far_boundary;
  problem.sides = own.sides;
  if (own.material == Material::heterogeneous_cells)
    problem.moduli.set_factor(random_factor(0.9, 3, grid.spacing_x()));
  if (own.material == Material::sphere)
    problem.moduli.set_sphere({0.5 * length, 0.3 * length, 0.3 * length},
                              0.3 * length,
                              moduli(mechanics::BodyModuli{2e10, 0.45}));
  return problem;
}

std::vector<BoxGridCase> all_cases() {
  std::vector<BoxGridCase> found;
  for (const int degree : {1, 2})
    for (const FarBoundary far_boundary :
         {FarBoundary::clamped, FarBoundary::sliding, FarBoundary::pressure})
      for (const BlockSides sides : {BlockSides::periodic, BlockSides::free})
        for (const Material material :
             {Material::layers, Material::heterogeneous_cells,
              Material::sphere})
          if (far_boundary != FarBoundary::pressure ||
              sides != BlockSides::free)
            found.push_back({degree, far_boundary, sides, material});
  return found;
}

class BoxGridCases : public ::testing::TestWithParam<BoxGridCase> {};

TEST_P(BoxGridCases, HaveTheStiffnessOfTheMatrix) {
  const BlockProblem problem = problem_of(GetParam());
  const BlockSystem system(problem);
  const std::optional<BoxGrid> box_grid = box_grid_of(problem);
  ASSERT_TRUE(box_grid.has_value());

  expect_matrix_product(system, BoxGridBlock(system, *box_grid));
}

// Verifies the solution with pinned nodes, springs of any stiffness and nodes
// in hard contact, which may stick under a clamped boundary.
TEST_P(BoxGridCases, HaveTheSolutionOfTheDirectSolver) {
  const BlockProblem problem = problem_of(GetParam());
  const BlockSystem system(problem);
  BoxGridBlock block(system, *box_grid_of(problem));
  for (const double spring : {0.0, 1e-2, 1e4}) {
    SCOPED_TRACE(spring);
    expect_direct_solution(
        system, block, {system, spring * soft_modulus * length / 8.0, false},
        100);
  }
  expect_direct_solution(system, block, {system, 0.0, true}, 100);
  if (GetParam().far_boundary == FarBoundary::clamped)
    expect_direct_solution(system, block, {system, 0.0, true, true}, 100);
}

std::string name_of(const ::testing::TestParamInfo<BoxGridCase>& info) {
  const BoxGridCase& own = info.param;
  const std::array<const char*, 3> materials{"layers", "heterogeneous",
                                             "sphere"};
  return "q" + std::to_string(own.degree) + "_top" +
         std::to_string(static_cast<int>(own.far_boundary)) +
         (own.sides == BlockSides::free ? "_free_" : "_periodic_") +
         materials.at(static_cast<std::size_t>(own.material));
}

INSTANTIATE_TEST_SUITE_P(All, BoxGridCases, ::testing::ValuesIn(all_cases()),
                         name_of);

// Verifies that a mesh that is not a grid of boxes is not treated as one.
TEST(BoxGridOfAMesh, IsNoneForOtherMeshes) {
  BlockProblem problem = problem_of(
      {1, FarBoundary::clamped, BlockSides::periodic, Material::layers});
  BlockProblem bent = problem;
  bent.mesh.vertices[3][2] += 0.01 * length;
  BlockProblem shifted = problem;
  shifted.mesh.vertices[9][0] += 0.01 * length;
  BlockProblem refined = problem;
  refined.mesh.refine_below = {0.1 * length};
  BlockProblem renumbered = problem;
  std::swap(renumbered.mesh.cells[0], renumbered.mesh.cells[1]);

  EXPECT_TRUE(box_grid_of(problem).has_value());
  EXPECT_FALSE(box_grid_of(bent).has_value());
  EXPECT_FALSE(box_grid_of(shifted).has_value());
  EXPECT_FALSE(box_grid_of(refined).has_value());
  EXPECT_FALSE(box_grid_of(renumbered).has_value());
}

} // namespace asperity::fem::box_grid_block_test
