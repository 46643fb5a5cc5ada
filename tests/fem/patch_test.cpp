// Tests of the unknowns of the full model on any mesh: the patch test. A
// homogeneous block under uniform pressure has uniform strain, which linear and
// quadratic shape functions represent exactly on any cells.
#include "fem/block/block_conduction.hpp"
#include "fem/newton/contact_newton.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"
#include "tests/message_of.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace asperity::fem::patch_test {

using mechanics::BlockSides;
using mechanics::FarBoundary;
using meshes::FaceGroup;

constexpr double poisson = 0.3;
constexpr double pressure = 1e6; // Pa

struct Patch {
  const char* name;
  bool is_tetrahedral;
  int degree;
  BlockSides sides;
  FarBoundary far_boundary;
};

class UniformPressure : public ::testing::TestWithParam<Patch> {
protected:
  const Grid grid_{6, 4, 3e-6, 2e-6};

  BlockProblem problem() const {
    const Patch& patch = GetParam();
    BlockProblem problem = boxes_problem(Grid{6, 4, 3e-6, 2e-6}, 1,
                                         {soft_modulus, poisson}, 2.5e-6);
    problem.degree = patch.degree;
    problem.far_boundary = patch.far_boundary;
    problem.sides = patch.sides;
    problem.linear_solver = LinearSolver::direct;
    if (patch.is_tetrahedral)
      problem.mesh = tetrahedra_of(problem.mesh);
    if (patch.sides == BlockSides::free)
      shake(problem.mesh, 0.2 * grid_.spacing_x());
    return problem;
  }
};

// u_z and, with free sides, u_x and u_y are those of uniaxial stress; with
// periodic sides they are those of uniaxial strain. Tolerance: roundoff of a
// direct solve, 1e-16 times a condition number of some 1e5.
TEST_P(UniformPressure, StrainsUniformly) {
  const BlockProblem block = problem();
  const BlockSystem system(block);
  ContactNewton contact(system, LinearSolver::direct);
  auto displacement = system.space().make_vector();

  ASSERT_TRUE(contact.solve_linear(
      std::vector<double>(system.contact().size(), pressure), displacement));

  const bool is_free = GetParam().sides == BlockSides::free;
  const Moduli stiff = moduli({soft_modulus, poisson});
  const double normal =
      is_free ? soft_modulus : stiff.lame_modulus + 2.0 * stiff.shear_modulus;
  const double across = is_free ? poisson * pressure / soft_modulus : 0.0;
  const double size = pressure / normal * block.mesh.depth;
  const Patch& patch = GetParam();
  std::size_t n_checked = 0;
  double pinned_x = 0.0, pinned_y = 0.0, pinned_z = 0.0;
  const auto corner = system.space().face_nodes(FaceGroup::contact).front();
  if (is_free) {
    pinned_x = corner.place[0] - displacement(corner.unknowns[0]) / across;
    pinned_y = corner.place[1] - displacement(corner.unknowns[1]) / across;
  }
  if (patch.far_boundary == FarBoundary::pressure)
    pinned_z = displacement(corner.unknowns[2]) - size;
  for (const FaceGroup group :
       {FaceGroup::contact, FaceGroup::left, FaceGroup::right, FaceGroup::front,
        FaceGroup::back})
    for (const FaceNode& node : system.space().face_nodes(group)) {
      if (system.space().constraints().is_constrained(node.unknowns[2]))
        continue;
      ++n_checked;
      EXPECT_NEAR(displacement(node.unknowns[2]),
                  pinned_z +
                      pressure / normal * (block.mesh.depth - node.place[2]),
                  1e-11 * size);
      EXPECT_NEAR(displacement(node.unknowns[0]),
                  across * (node.place[0] - pinned_x), 1e-11 * size);
      EXPECT_NEAR(displacement(node.unknowns[1]),
                  across * (node.place[1] - pinned_y), 1e-11 * size);
    }
  EXPECT_GT(n_checked, 20U);
}

// With all nodes in contact the temperature is linear, and the block conducts
// area over depth. Tolerance: the square of that of the linear solve.
TEST_P(UniformPressure, ConductsUniformly) {
  const BlockProblem block = problem();
  const BlockSystem system(block);
  const std::vector<bool> all(system.contact().size(), true);

  const BlockConduction found = conduction(system, all, block.mesh.depth);

  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.conductance * block.mesh.depth / grid_.area(), 1.0, 1e-13);
  EXPECT_TRUE(std::isinf(found.relative));
}

INSTANTIATE_TEST_SUITE_P(
    Patches, UniformPressure,
    ::testing::Values(
        Patch{"hexes_free", false, 1, BlockSides::free, FarBoundary::sliding},
        Patch{"hexes2_free", false, 2, BlockSides::free, FarBoundary::sliding},
        Patch{"tets_free", true, 1, BlockSides::free, FarBoundary::sliding},
        Patch{"hexes_periodic", false, 1, BlockSides::periodic,
              FarBoundary::clamped},
        Patch{"hexes_loaded", false, 1, BlockSides::periodic,
              FarBoundary::pressure},
        Patch{"tets_periodic", true, 1, BlockSides::periodic,
              FarBoundary::clamped}),
    [](const auto& tested) { return std::string(tested.param.name); });

// Verifies the messages that refuse invalid blocks.
TEST(UniformPressureRefusals, NameTheMistake) {
  BlockProblem block =
      boxes_problem({4, 4, 1e-6, 1e-6}, 1, {soft_modulus, poisson}, 1e-6);
  const auto words = [](const BlockProblem& problem) -> std::string {
    return tests::message_of<std::domain_error>(
        [&] { make_full_block(problem); });
  };

  BlockProblem tilting = block;
  tilting.sides = BlockSides::free;
  tilting.far_boundary = FarBoundary::pressure;
  EXPECT_NE(words(tilting).find("tilt as a rigid body"), std::string::npos);

  BlockProblem unmatched = block;
  for (meshes::Place& place : unmatched.mesh.vertices)
    if (place[0] == 1e-6 && place[1] == 0.5e-6)
      place[1] += 1e-8;
  EXPECT_NE(words(unmatched).find("do not match"), std::string::npos);

  BlockProblem weightless = block;
  weightless.mesh = tetrahedra_of(block.mesh);
  weightless.degree = 2;
  EXPECT_NE(words(weightless).find("choose element = Q1"), std::string::npos);

  BlockProblem cut = block;
  cut.mesh = tetrahedra_of(block.mesh);
  cut.mesh.refine_below = {5e-7};
  EXPECT_NE(words(cut).find("tetrahedra"), std::string::npos);
  EXPECT_EQ(words(block), "accepted");
}

} // namespace asperity::fem::patch_test
