// Tests of fem/linear/hexahedron_block.hpp: the stiffness of second-order
// hexahedra without a matrix, and multigrid with first-order functions,
// compared with deal.II's assembled matrix and the direct solver.
#include "fem/linear/block_solver.hpp"
#include "fem/linear/hexahedron_block.hpp"
#include "meshes/counter_body.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/fem/block_vectors.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace asperity::fem::hexahedron_block_test {

using mechanics::BlockSides;
using mechanics::FarBoundary;

constexpr double length = 1e-6; // m

struct HexahedronCase {
  const char* name;
  FarBoundary far_boundary;
  BlockSides sides;
  bool is_shaken = false;
  bool is_pair = false; ///< with a column of its own mesh below
};

/// A body below the middle of the block, with cells of that size.
meshes::BlockMesh body(mechanics::CounterShape shape, double size) {
  const double radius = 0.4 * length;
  const bool is_ball = shape == mechanics::CounterShape::sphere;
  return meshes::counter_body({.shape = shape,
                               .radius = radius,
                               .height = radius,
                               .size_at_contact = size,
                               .size_far = 2.0 * size,
                               .fine_radius = is_ball ? 0.4 * radius : radius,
                               .centre_x = 0.5 * length,
                               .centre_y = 0.5 * length});
}

meshes::BlockMesh column() {
  return meshes::counter_body({.shape = mechanics::CounterShape::cylinder,
                               .radius = 0.35 * length,
                               .height = 0.5 * length,
                               .size_at_contact = 0.25 * length,
                               .size_far = 0.3 * length,
                               .fine_radius = 0.35 * length,
                               .centre_x = 0.5 * length,
                               .centre_y = 0.52 * length});
}

/// Two materials on cubes of two sizes with hanging nodes between them.
BlockProblem problem_of(const HexahedronCase& own, int cells = 4) {
  const Grid grid{2 * cells, 2 * cells, length, length};
  BlockProblem problem{
      grid,
      meshes::hanging_mesh({cells, cells, length, length}, length, cells / 4),
      2, ModuliField(moduli(mechanics::BodyModuli{soft_modulus, 0.2}))};
  problem.moduli.add_layer(
      0.3 * length, moduli(mechanics::BodyModuli{5.0 * soft_modulus, 0.4}));
  problem.far_boundary = own.far_boundary;
  problem.sides = own.sides;
  if (own.is_shaken)
    shake(problem.mesh, 0.6 * length / cells);
  if (own.is_pair) {
    problem.counter = mechanics::BodyModuli{2.0 * soft_modulus, 0.2};
    problem.counter_mesh = column();
  }
  return problem;
}

const HexahedronCase shaken{"shaken", FarBoundary::clamped, BlockSides::free,
                            true};

std::vector<HexahedronCase> all_cases() {
  return {
      shaken,
      {"shaken_sliding", FarBoundary::sliding, BlockSides::free, true},
      {"periodic_sliding", FarBoundary::sliding, BlockSides::periodic},
      {"periodic_pressure", FarBoundary::pressure, BlockSides::periodic},
      {"pair", FarBoundary::clamped, BlockSides::free, true, true},
      {"pair_periodic", FarBoundary::clamped, BlockSides::periodic, false,
       true},
  };
}

class HexahedronCases : public ::testing::TestWithParam<HexahedronCase> {};

TEST_P(HexahedronCases, HaveTheStiffnessOfTheMatrix) {
  const BlockProblem problem = problem_of(GetParam());
  const BlockSystem system(problem);
  ASSERT_TRUE(is_hexahedron_block(system));
  ASSERT_FALSE(problem.mesh.refine_below.empty());
  ASSERT_GT(system.space().constraints().n_constraints(), 0U);

  expect_matrix_product(system, HexahedronBlock(problem, system));
}

// Verifies the solution with pinned nodes, springs of any stiffness and nodes
// in hard contact.
TEST_P(HexahedronCases, HaveTheSolutionOfTheDirectSolver) {
  const BlockProblem problem = problem_of(GetParam());
  const BlockSystem system(problem);
  HexahedronBlock block(problem, system);
  for (const double spring : {0.0, 1e-2, 1e4}) {
    SCOPED_TRACE(spring);
    expect_direct_solution(
        system, block, {system, spring * soft_modulus * length / 8.0, false},
        40);
  }
  if (!system.has_counter())
    expect_direct_solution(system, block, {system, 0.0, true}, 40);
}

std::string name_of(const ::testing::TestParamInfo<HexahedronCase>& tested) {
  return tested.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, HexahedronCases, ::testing::ValuesIn(all_cases()),
                         name_of);

// Verifies that the iterations to 1e-8 are bounded for two sizes of the mesh,
// without contact and with springs of any stiffness or nodes in hard contact.
TEST(HexahedronBlockIterations, AreBounded) {
  for (const int cells : {8, 16}) {
    const BlockProblem problem = problem_of(shaken, cells);
    const BlockSystem system(problem);
    const double unit = soft_modulus * length / cells;
    for (const double spring : {0.0, 1.0, 1e4, -1.0}) {
      HexahedronBlock block(problem, system);
      const bool is_held = spring < 0.0;

      const int iterations = iterations_with(
          block, {system, is_held ? 0.0 : spring * unit, is_held});

      EXPECT_LE(iterations, 20) << cells << " cells, spring " << spring;
    }
  }
}

// Verifies that springs between the nodes of a block and a ball or a cuboid may
// be of any stiffness. Measured: at most 26.
TEST(HexahedronBlockIterations, AreBoundedBetweenBodies) {
  for (const auto shape :
       {mechanics::CounterShape::sphere, mechanics::CounterShape::cuboid}) {
    BlockProblem problem = problem_of(shaken, 8);
    problem.counter = mechanics::BodyModuli{2.0 * soft_modulus, 0.2};
    problem.counter_mesh = body(shape, length / 8.0);
    const BlockSystem system(problem);
    HexahedronBlock block(problem, system);
    for (const double spring : {0.0, 1.0, 1e2, 1e4, 1e8}) {
      const PartialContact contact(system, spring * soft_modulus * length / 8.0,
                                   false, false, 1.0);

      EXPECT_LE(iterations_with(block, contact), 30)
          << static_cast<int>(shape) << ", spring " << spring;
    }
  }
}

// First-order bodies with an assembled matrix, whose joined nodes have their
// relative displacement as the unknown: springs of any stiffness cost no more
// iterations than none, up to a quarter. Measured: 33 to 39, and 39 without.
TEST(JoinedNodesIterations, DoNotGrowWithTheSpringsBetweenBodies) {
  for (const auto shape :
       {mechanics::CounterShape::sphere, mechanics::CounterShape::cuboid}) {
    BlockProblem problem = problem_of(shaken, 16);
    problem.degree = 1;
    problem.counter = mechanics::BodyModuli{2.0 * soft_modulus, 0.2};
    problem.counter_mesh = body(shape, length / 16.0);
    const BlockSystem system(problem);
    const auto with_spring = [&](double spring) {
      BlockSolver solver(system, LinearSolver::multigrid);
      const PartialContact contact(
          system, spring * soft_modulus * length / 16.0, false, false, 1.0);
      solver.set_contact(contact.springs, contact.held);
      BlockVector found(contact.force);
      found = 0.0;
      EXPECT_TRUE(
          solver.solve(found, contact.force, 1e-8 * contact.force.l2_norm()));
      return solver.iterations();
    };

    const int without = with_spring(0.0);

    for (const double spring : {1.0, 1e2, 1e4, 1e6})
      EXPECT_LE(with_spring(spring), 1.25 * without)
          << static_cast<int>(shape) << ", spring " << spring;
  }
}

// Verifies that a hierarchy is reused while only the set of nodes in hard
// contact changes, and built again for other springs.
TEST(HexahedronBlockHierarchy, IsKeptForSimilarContact) {
  const BlockProblem problem = problem_of(shaken, 8);
  const BlockSystem system(problem);
  HexahedronBlock block(problem, system);

  static_cast<void>(iterations_with(block, {system, 0.0, true, false, 0.4}));
  static_cast<void>(iterations_with(block, {system, 0.0, true, false, 0.45}));

  EXPECT_EQ(block.setups(), 1);
  static_cast<void>(
      iterations_with(block, {system, soft_modulus * length, false}));
  EXPECT_EQ(block.setups(), 2);
}

} // namespace asperity::fem::hexahedron_block_test
