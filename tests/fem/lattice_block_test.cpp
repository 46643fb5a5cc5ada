// Tests of fem/linear/lattice_block.hpp: the stiffness without a matrix and
// geometric multigrid, compared with deal.II's assembled matrix and the direct
// solver. The tests also run on two and three ranks, which share the rows.
#include "fem/linear/block_solver.hpp"
#include "fem/linear/lattice_block.hpp"
#include "tests/fem/block_vectors.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <gtest/gtest.h>

namespace asperity::fem::lattice_block_test {

using mechanics::BlockSides;
using mechanics::FarBoundary;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr double length = 1e-6; // m

enum class Material { layers, heterogeneous_cells, sphere };

struct LatticeCase {
  int degree;
  FarBoundary far_boundary;
  BlockSides sides;
  Material material;
};

/// Boxes with unequal sides, 8 nodes and 12 rows of cells per plane, in layers
/// of any thickness.
BlockProblem problem_of(const LatticeCase& own) {
  const Grid cells{8 / own.degree, 12, length, 1.2 * length};
  const Grid grid{8, 12 * own.degree, length, 1.2 * length};
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

std::vector<LatticeCase> all_cases() {
  std::vector<LatticeCase> found;
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

class LatticeCases : public ::testing::TestWithParam<LatticeCase> {};

// Verifies K u without a matrix against deal.II's matrix. Tolerance: roundoff
// of a sum over the unknowns of a cell.
TEST_P(LatticeCases, HaveTheStiffnessOfTheMatrix) {
  const BlockProblem problem = problem_of(GetParam());
  const BlockSystem system(problem);
  const std::optional<BoxLattice> lattice = box_lattice(problem);
  ASSERT_TRUE(lattice.has_value());
  const LatticeBlock block(system, *lattice);
  const Vector displacement = random_vector(system, 1);
  Vector found(displacement), expected(displacement);

  block.vmult(found, displacement);

  system.stiffness().vmult(expected, displacement);
  EXPECT_LT(relative_difference(found, expected), 1e-13);
}

/// The support of the contact surface.
struct Support {
  double spring = 0.0; ///< under the first half of the points [N/m]
  bool is_held = false;
};

void expect_direct_solution(const BlockProblem& problem,
                            const Support& support) {
  const BlockSystem system(problem);
  LatticeBlock block(system, *box_lattice(problem));
  BlockSolver direct(system, LinearSolver::direct);
  std::vector<double> springs(system.contact().size(), 0.0);
  std::vector<bool> held(springs.size(), false);
  Vector force = random_vector(system, 2);
  for (std::size_t i = 0; i < springs.size() / 2; ++i) {
    springs[i] = support.spring;
    held[i] = support.is_held;
    if (support.is_held)
      force(system.contact()[i].row.front().first) = 0.0;
  }
  force.compress(dealii::VectorOperation::insert);
  Vector expected = system.space().make_vector();
  direct.set_contact(springs, held);
  ASSERT_TRUE(direct.solve(expected, force, 0.0));
  Vector found = system.space().make_vector();
  block.prepare(springs, held, false);

  const LinearSolution solution =
      block.solve(found, force, 1e-13 * force.l2_norm(), 100);

  EXPECT_TRUE(solution.has_converged) << solution.last_residual;
  EXPECT_LT(relative_difference(found, expected), 1e-9);
}

// Verifies the solution against the direct solver, with pinned nodes, springs
// of any stiffness and nodes in hard contact. Tolerance: the residual times the
// condition number.
TEST_P(LatticeCases, HaveTheSolutionOfTheDirectSolver) {
  const BlockProblem problem = problem_of(GetParam());
  const double stiffness = soft_modulus * length / 8.0;

  for (const double spring : {0.0, 1e-2, 1e4}) {
    SCOPED_TRACE(spring);
    expect_direct_solution(problem, {spring * stiffness, false});
  }
  expect_direct_solution(problem, {0.0, true});
}

std::string name_of(const ::testing::TestParamInfo<LatticeCase>& info) {
  const LatticeCase& own = info.param;
  const std::array<const char*, 3> materials{"layers", "heterogeneous",
                                             "sphere"};
  return "q" + std::to_string(own.degree) + "_top" +
         std::to_string(static_cast<int>(own.far_boundary)) +
         (own.sides == BlockSides::free ? "_free_" : "_periodic_") +
         materials.at(static_cast<std::size_t>(own.material));
}

INSTANTIATE_TEST_SUITE_P(All, LatticeCases, ::testing::ValuesIn(all_cases()),
                         name_of);

// Verifies that a mesh that is not a grid of boxes is not treated as one.
TEST(BoxLatticeOfAMesh, IsNoneForOtherMeshes) {
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

  EXPECT_TRUE(box_lattice(problem).has_value());
  EXPECT_FALSE(box_lattice(bent).has_value());
  EXPECT_FALSE(box_lattice(shifted).has_value());
  EXPECT_FALSE(box_lattice(refined).has_value());
  EXPECT_FALSE(box_lattice(renumbered).has_value());
}

} // namespace asperity::fem::lattice_block_test
