// Tests of fem/refined/refined_block.hpp: first-order boxes with hanging nodes
// without a matrix, and multigrid on coarser meshes for first and second order,
// compared with deal.II's assembled matrix and the direct solver.
#include "fem/block/block_triangulation.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "fem/refined/refined_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/fem/block_vectors.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

namespace asperity::fem::refined_block_test {

using mechanics::BlockSides;
using mechanics::FarBoundary;

constexpr double length = 1e-6; // m

struct RefinedCase {
  const char* name;
  FarBoundary far_boundary;
  BlockSides sides;
  int degree = 1;
};

/// Two materials on boxes that are halved at the contact surface, and there
/// round a corner of the contact of PartialContact. Edges differ along x, y and
/// z.
struct RefinedMesh {
  BlockProblem problem;
  BlockSystem system;

  RefinedMesh(const RefinedCase& own, int cells, int halvings)
      : problem(problem_of(own, cells)), system(problem, mesh(halvings)) {}

  static BlockProblem problem_of(const RefinedCase& own, int cells) {
    const Grid grid{32, 32, length, 1.25 * length};
    BlockProblem problem{
        grid,
        meshes::layered_mesh({cells, cells, length, 1.25 * length},
                             std::vector<double>{0.2 * length, 0.3 * length,
                                                 0.4 * length, 0.5 * length}),
        own.degree,
        ModuliField(moduli(mechanics::BodyModuli{soft_modulus, 0.2}))};
    problem.moduli.add_layer(
        0.2 * length, moduli(mechanics::BodyModuli{5.0 * soft_modulus, 0.4}));
    problem.far_boundary = own.far_boundary;
    problem.sides = own.sides;
    problem.linear_solver = LinearSolver::multigrid;
    return problem;
  }

  std::shared_ptr<dealii::parallel::TriangulationBase<3>>
  mesh(int halvings) const {
    start_mpi();
    auto made = make_triangulation(problem.mesh, false);
    for (int pass = 0; pass < halvings; ++pass) {
      for (const auto& cell : made->active_cell_iterators()) {
        if (!cell->is_locally_owned())
          continue;
        const dealii::Point<3> centre = cell->center();
        if (centre[2] < cell->extent_in_direction(2) &&
            (pass == 0 || centre.distance({0.5 * length, 0.6 * length, 0.0}) <
                              0.5 * length / (1 << pass)))
          cell->set_refine_flag();
      }
      made->execute_coarsening_and_refinement();
    }
    return made;
  }
};

const RefinedCase usual{"free", FarBoundary::clamped, BlockSides::free};

std::vector<RefinedCase> all_refined_cases() {
  return {
      usual,
      {"periodic", FarBoundary::clamped, BlockSides::periodic},
      {"free_sliding", FarBoundary::sliding, BlockSides::free},
      {"periodic_sliding", FarBoundary::sliding, BlockSides::periodic},
      {"periodic_pressure", FarBoundary::pressure, BlockSides::periodic},
      {"second_order", FarBoundary::clamped, BlockSides::free, 2},
      {"second_order_periodic", FarBoundary::sliding, BlockSides::periodic, 2}};
}

class RefinedCases : public ::testing::TestWithParam<RefinedCase> {};

TEST_P(RefinedCases, HaveTheStiffnessOfTheMatrix) {
  const RefinedMesh own(GetParam(), 4, 2);

  expect_matrix_product(own.system, *refined_block_of(own.problem, own.system));
}

// Verifies the solution with pinned nodes, springs of any stiffness, and nodes
// that are held and slide or stick.
TEST_P(RefinedCases, HaveTheSolutionOfTheDirectSolver) {
  const RefinedMesh own(GetParam(), 4, 2);
  const std::unique_ptr<BlockInverse> block =
      refined_block_of(own.problem, own.system);
  for (const double spring : {0.0, 1e-2, 1e4}) {
    SCOPED_TRACE(spring);
    expect_direct_solution(
        own.system, *block,
        {own.system, spring * soft_modulus * length / 16.0, false}, 60);
  }
  for (const bool sticks : {false, true})
    expect_direct_solution(own.system, *block, {own.system, 0.0, true, sticks},
                           60);
}

std::string name_of(const ::testing::TestParamInfo<RefinedCase>& tested) {
  return tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, RefinedCases,
                         ::testing::ValuesIn(all_refined_cases()), name_of);

// Verifies that the iterations to 1e-8 are bounded, whatever the number of
// halvings, without contact, with springs of any stiffness, and with held
// nodes. The bound is that of the grid of boxes, 12 with the stiffest springs,
// and half as many more for materials and hanging nodes. Cells have an aspect
// of two at most, because first-order functions correct those of second order
// badly on slender cells.
TEST(RefinedBlockIterations, AreBounded) {
  for (const int degree : {1, 2})
    for (const int halvings : {0, 1, 4}) {
      RefinedCase own = usual;
      own.degree = degree;
      const RefinedMesh mesh(own, 4, halvings);
      const std::unique_ptr<BlockInverse> block =
          refined_block_of(mesh.problem, mesh.system);
      ASSERT_TRUE(block);
      for (const double spring : {0.0, 1.0, 1e4, -1.0}) {
        const bool is_held = spring < 0.0;
        const PartialContact contact(
            mesh.system,
            is_held ? 0.0 : spring * soft_modulus * length / (4 << halvings),
            is_held);

        EXPECT_LE(iterations_with(*block, contact), 18)
            << "order " << degree << ", " << halvings << " halvings, spring "
            << spring;
      }
      EXPECT_EQ(block->setups(), 1);
    }
}

// Verifies which meshes are left to other solvers.
TEST(RefinedBlock, NeedsABoxGridOfCoarsestCells) {
  RefinedMesh mesh(usual, 4, 1);
  EXPECT_TRUE(is_refined_block(mesh.problem));
  shake(mesh.problem.mesh, 0.02 * length);
  EXPECT_FALSE(is_refined_block(mesh.problem));
}

} // namespace asperity::fem::refined_block_test
