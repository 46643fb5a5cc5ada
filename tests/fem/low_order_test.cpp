// Tests of fem/block/block_assembly.hpp: the matrix of first-order cells that
// replaces that of a second-order block in the preconditioner. The references
// are a mesh of these small cells and the condition number of one matrix
// relative to the other.
#include "fem/block/block_assembly.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/trilinos_solver.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace asperity::fem::low_order_test {

using Matrix = dealii::TrilinosWrappers::SparseMatrix;
using Vector = dealii::TrilinosWrappers::MPI::Vector;

constexpr double length = 1e-6; // m
const mechanics::BodyModuli body{soft_modulus, 0.3};

/// A displacement that is periodic in x and y and zero at the far boundary.
Vector smooth_displacement(const BlockSystem& system) {
  const BlockSpace& space = system.space();
  std::vector<dealii::Point<3>> places(system.n_unknowns());
  dealii::DoFTools::map_dofs_to_support_points(space.mapping(),
                                               space.dof_handler(), places);
  std::vector<std::vector<bool>> of_component;
  dealii::DoFTools::extract_constant_modes(
      space.dof_handler(), dealii::ComponentMask(3, true), of_component);
  Vector displacement = space.make_vector();
  for (unsigned int i = 0; i < system.n_unknowns(); ++i) {
    if (space.constraints().is_constrained(i))
      continue;
    const double turn = 2.0 * std::numbers::pi / length;
    const double shape = of_component[0][i]   ? std::sin(turn * places[i][0])
                         : of_component[1][i] ? std::cos(turn * places[i][0])
                                              : std::cos(turn * places[i][1]);
    displacement(i) = shape * (length - places[i][2]);
  }
  displacement.compress(dealii::VectorOperation::insert);
  return displacement;
}

double twice_energy(const Matrix& matrix, const Vector& displacement) {
  Vector forces(displacement);
  matrix.vmult(forces, displacement);
  return forces * displacement;
}

// On boxes K_1 is the stiffness of the block that is meshed with first-order
// boxes between the same nodes. Tolerance: roundoff of a sum over the cells.
TEST(LowOrderMatrix, IsTheStiffnessOfTheSmallBoxes) {
  const Grid grid{8, 12, length, length};
  const BlockProblem coarse = boxes_problem(grid, 2, body, length);
  BlockProblem fine = boxes_problem(grid, 1, body, length);
  std::vector<double> halves;
  for (const double thickness :
       meshes::graded_layers(2.0 * grid.spacing_x(), 1.4, length))
    halves.insert(halves.end(), 2, 0.5 * thickness);
  fine.mesh = meshes::layered_mesh(grid, halves);
  const BlockSystem second(coarse), first(fine);
  Matrix low_order;
  assemble_low_order(second, low_order);

  const double found = twice_energy(low_order, smooth_displacement(second));

  const double expected =
      twice_energy(first.stiffness(), smooth_displacement(first));
  ASSERT_EQ(second.n_unknowns(), first.n_unknowns());
  EXPECT_NEAR(found / expected, 1.0, 1e-12);
  EXPECT_LT(low_order.n_nonzero_elements(),
            second.stiffness().n_nonzero_elements() / 2);
}

/// The exact inverse of a matrix.
class Inverse {
public:
  explicit Inverse(const Matrix& matrix)
      : direct_(control_,
                dealii::TrilinosWrappers::SolverDirect::AdditionalData(
                    false, "Amesos_Klu")) {
    direct_.initialize(matrix);
  }

  void vmult(Vector& to, const Vector& from) const { direct_.solve(to, from); }

private:
  dealii::SolverControl control_;
  mutable dealii::TrilinosWrappers::SolverDirect direct_;
};

/// Iterations of conjugate gradients to 1e-10 of a random load, preconditioned
/// by the inverse of K_1.
unsigned int steps_of(const BlockProblem& problem) {
  const BlockSystem system(problem);
  Matrix low_order;
  assemble_low_order(system, low_order);
  const std::vector<double> numbers = random_field(system.n_unknowns(), 3);
  Vector load = system.space().make_vector();
  for (unsigned int i = 0; i < system.n_unknowns(); ++i)
    if (!system.space().constraints().is_constrained(i))
      load(i) = numbers[i] - 0.5;
  load.compress(dealii::VectorOperation::insert);
  Vector displacement = system.space().make_vector();
  dealii::SolverControl control(200, 1e-10 * load.l2_norm());
  dealii::SolverCG<Vector> conjugate_gradients(control);
  conjugate_gradients.solve(system.stiffness(), displacement, load,
                            Inverse(low_order));
  return control.last_step();
}

// Verifies (F.4): the condition number of K relative to K_1 is of order one on
// any cells. The iterations to 1e-10 are below sqrt(condition) / 2 * ln(2e10):
// 36 for the stated bound of 9. Uncoupled or wrongly numbered cells need
// hundreds.
TEST(LowOrderMatrix, IsEquivalentToTheSecondOrderOne) {
  for (const int points : {8, 16}) {
    const BlockProblem boxes =
        boxes_problem({points, points, length, length}, 2, body, length);
    BlockProblem shaken = boxes;
    shaken.sides = mechanics::BlockSides::free;
    shake(shaken.mesh, 0.3 * length / points);
    BlockProblem heterogeneous = boxes;
    heterogeneous.moduli.set_factor(
        random_factor(0.5, 1, 2.0 * length / points));

    EXPECT_LT(steps_of(boxes), 36U);
    EXPECT_LT(steps_of(shaken), 36U);
    EXPECT_LT(steps_of(heterogeneous), 36U);
  }
  BlockProblem hanging =
      boxes_problem({16, 16, length, length}, 2, body, length);
  hanging.mesh = meshes::hanging_mesh({8, 8, length, length}, length, 2);
  EXPECT_LT(steps_of(hanging), 36U);
}

} // namespace asperity::fem::low_order_test
