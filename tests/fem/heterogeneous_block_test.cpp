// Tests of fem/waves/lattice_solver.hpp as a preconditioner of heterogeneous
// blocks: the number of iterations of conjugate gradients.
#include "fem/waves/lattice_solver.hpp"
#include "tests/fem/heterogeneous_block.hpp"

#include <gtest/gtest.h>

#include <tuple>

namespace asperity::fem::heterogeneous_block_test {

/// Iterations of conjugate gradients to 1e-10 of the load, with cells that vary
/// by 50 %.
unsigned int iterations(int degree, int points, double stiffness) {
  const Grid grid{points, points, 1e-6, 1e-6};
  const LayeredBlock uniform = homogeneous_block(
      meshes::graded_layers(degree * grid.spacing_x(), 1.2, grid.length_x),
      soft_modulus, 0.3, mechanics::FarBoundary::clamped);
  const std::vector<double> springs = springs_under_peaks(
      grid, 0.2, stiffness * soft_modulus * grid.spacing_x());
  const HeterogeneousBlock block(grid, degree, uniform, 0.5, 3, springs);
  LatticeSolver solver(grid, degree, uniform);
  solver.set_springs(springs);
  const dealii::Vector<double> force = block.loads(5);
  dealii::Vector<double> displacement(force.size());
  dealii::SolverControl control(200, 1e-10 * force.l2_norm(), false, false);

  dealii::SolverCG<dealii::Vector<double>>(control).solve(
      block.matrix(), displacement, force,
      LatticePreconditioner(solver, 1e-12));

  dealii::Vector<double> residual(force);
  block.matrix().vmult(residual, displacement);
  residual -= force;
  EXPECT_LT(residual.l2_norm(), 1.1e-10 * force.l2_norm());
  return control.last_step();
}

class HeterogeneousCells : public ::testing::TestWithParam<double> {};

// Verifies that neither the grid nor the springs change the number of
// iterations. The preconditioned spectrum lies within 0.5..1.5, the range of
// the factors of the cells (K is between 0.5 and 1.5 times the uniform K;
// springs draw both towards 1), so that the condition number is at most 3 and
// the error in energy decreases by (sqrt 3 - 1)/(sqrt 3 + 1) per step: 2
// (0.268)^n, 19 steps to 1e-10 and three more for the square root of the
// condition number between energy and residual, about 1e2. The two grids may
// differ by the one step at which the same residual crosses the tolerance.
TEST_P(HeterogeneousCells, TakeTheSameIterationsOnAnyGrid) {
  const unsigned int coarse = iterations(1, 16, GetParam());
  const unsigned int fine = iterations(1, 32, GetParam());

  EXPECT_NEAR(static_cast<double>(coarse), static_cast<double>(fine), 1.0);
  EXPECT_LE(fine, 22u);
}

INSTANTIATE_TEST_SUITE_P(Springs, HeterogeneousCells,
                         ::testing::Values(0.0, 0.1, 10.0, 1e4));

TEST(HeterogeneousQuadraticCells, TakeNoMore) {
  EXPECT_LE(iterations(2, 16, 0.0), 22u);
  EXPECT_LE(iterations(2, 16, 10.0), 22u);
}

} // namespace asperity::fem::heterogeneous_block_test
