// Tests of FullBlock::stiffness(): the stiffness of a Hertz contact against
// Mindlin's, against the slope of the load, and of all linear solvers.
#include "fem/block/block_problem.hpp"
#include "fem/block/full_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "surfaces/maps/exact_shapes.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"
#include "theory/exact/hertz.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace asperity::fem::contact_stiffness_test {

using mechanics::Control;

constexpr double length = 1e-3;          // m, side and depth
constexpr double sphere = 10.0 * length; // m, its radius
constexpr double radius = 0.12 * length; // m, of the contact

struct Body {
  double poisson = 0.0;
  double modulus = soft_modulus / (1.0 - poisson * poisson); ///< E* [Pa]
  double shear = soft_modulus / (2.0 * (1.0 + poisson));     ///< G [Pa]
  /// Of uniform uniaxial strain [Pa].
  double oedometric = 2.0 * shear * (1.0 - poisson) / (1.0 - 2.0 * poisson);
};

BlockSolution press(FullBlock& block, const Body& body, double load) {
  return block.solve(surfaces::paraboloid(block.grid(), sphere).heights,
                     {Control::nominal_pressure, load / (length * length)},
                     {mechanics::ContactLaw::hard,
                      1e3 * body.modulus / block.grid().spacing_x(), 1e-10,
                      100});
}

double load_of(const Body& body) {
  return theory::hertz_load(radius, sphere, body.modulus);
}

ContactStiffness stiffness_of(FullBlock& block, const Body& body) {
  EXPECT_TRUE(press(block, body, load_of(body)).converged);
  ContactStiffness found = block.stiffness();
  EXPECT_TRUE(found.converged);
  return found;
}

std::unique_ptr<FullBlock> block_of(int points, int degree, const Body& body) {
  const Grid grid{points, points, length, length};
  return make_full_block(
      grid, degree,
      homogeneous_block(
          meshes::graded_layers(degree * grid.spacing_x(), 1.2, length),
          soft_modulus, body.poisson, mechanics::FarBoundary::clamped));
}

/// The compliance of a single contact on a half-space [m/N]: without the
/// uniform strain of the block and the displacement by the periodic images.
/// The images displace each other by the grid of boxes sum of 1/r, times
/// (1 - nu)/(2 pi G) along z and, as the mean over directions,
/// (2 - nu)/(4 pi G) laterally.
double single(double stiffness, double uniform_modulus, double far_compliance) {
  return 1.0 / stiffness - 1.0 / (uniform_modulus * length) +
         theory::square_array_constant() * far_compliance / length;
}

double mindlin_ratio(const ContactStiffness& found, const Body& body) {
  const double normal =
      single(found.normal, body.oedometric,
             (1.0 - body.poisson) / (2.0 * std::numbers::pi * body.shear));
  const double tangential =
      single(found.tangential, body.shear,
             (2.0 - body.poisson) / (4.0 * std::numbers::pi * body.shear));
  return normal / tangential;
}

// k_t / k_n = 2 (1 - nu)/(2 - nu) (Mindlin 1949) for one elastic body.
// Tolerance: measured 1.4 and 0.8 % for nu = 0.3 and 0.45, and 1.2 and 0.6 % at
// 128 points. What remains is the normal traction of nodes that stick, which
// Mindlin neglects and which falls with 1 - 2 nu, and (a/L)^3 of the images.
TEST(ContactStiffness, HasMindlinsRatio) {
  for (const double poisson : {0.3, 0.45}) {
    const Body body{poisson};
    const ContactStiffness found = stiffness_of(*block_of(64, 2, body), body);

    const double ratio = mindlin_ratio(found, body);
    EXPECT_NEAR(ratio * (2.0 - poisson) / (2.0 * (1.0 - poisson)), 1.0, 0.015);
  }
}

// The normal stiffness is the slope of the load over the approach of the far
// boundary. Loads that differ little have the same nodes in contact, for which
// the load is linear in the approach. The mean gap leaves out the uniform
// strain of the block. Tolerance: differences of 1e-3 of the load whose
// relative error is 1e-10.
TEST(ContactStiffness, IsTheSlopeOfTheLoad) {
  const Body body{0.3};
  const auto block = block_of(32, 2, body);
  const BlockSolution one = press(*block, body, load_of(body));
  const BlockSolution other = press(*block, body, 1.001 * load_of(body));
  const double force =
      (other.nominal_pressure - one.nominal_pressure) * length * length;

  const ContactStiffness found = block->stiffness();

  EXPECT_EQ(one.area_by_points, other.area_by_points);
  EXPECT_NEAR(found.normal * ((one.mean_gap - other.mean_gap) / force +
                              1.0 / (body.oedometric * length)),
              1.0, 1e-6);
}

// All linear solvers find the same stiffness of the same block: on layers the
// direct one and the grid of boxes, and on a mesh with hanging nodes the direct
// one and multigrid for hexahedra. Tolerance: that of the linear solves.
TEST(ContactStiffness, IsThatOfAllLinearSolvers) {
  for (const int degree : {1, 2})
    for (const bool hangs : {false, true}) {
      BlockProblem problem = boxes_problem({16, 16, length, length}, degree,
                                           {soft_modulus, 0.3}, length);
      const Grid columns{16 / degree, 16 / degree, length, length};
      problem.mesh =
          hangs ? meshes::hanging_mesh(columns, length, 2)
                : meshes::layered_mesh(
                      columns,
                      meshes::graded_layers(columns.spacing_x(), 2.0, length));
      const auto with = [&](LinearSolver solver) {
        problem.linear_solver = solver;
        return stiffness_of(*make_full_block(problem), Body{0.3});
      };

      const ContactStiffness direct = with(LinearSolver::direct);
      const ContactStiffness found = with(LinearSolver::multigrid);

      EXPECT_NEAR(found.normal / direct.normal, 1.0, 1e-7);
      EXPECT_NEAR(found.tangential / direct.tangential, 1.0, 1e-7);
    }
}

// The next load step after a stiffness is that without one, at the same cost.
// Tolerance: that of the load steps.
TEST(ContactStiffness, LeavesTheNextStepAsItIs) {
  const Body body{0.3};
  const auto block = block_of(16, 2, body);
  const auto other = block_of(16, 2, body);
  stiffness_of(*block, body);
  press(*other, body, load_of(body));

  const BlockSolution after = press(*block, body, 2.0 * load_of(body));
  const BlockSolution without = press(*other, body, 2.0 * load_of(body));

  EXPECT_EQ(after.linear_iterations, without.linear_iterations);
  EXPECT_NEAR(after.mean_gap / without.mean_gap, 1.0, 1e-9);
}

TEST(ContactStiffness, IsZeroBeforeContact) {
  const auto block = block_of(16, 2, Body{0.3});

  EXPECT_EQ(block->stiffness().normal, 0.0);
  EXPECT_EQ(block->stiffness().tangential, 0.0);
}

TEST(ContactStiffness, NeedsAClampedFarBoundary) {
  const Grid grid{16, 16, length, length};
  BlockProblem problem = boxes_problem(grid, 1, {soft_modulus, 0.3}, length);
  problem.far_boundary = mechanics::FarBoundary::sliding;
  EXPECT_THROW(make_full_block(problem)->stiffness(), std::domain_error);
}

} // namespace asperity::fem::contact_stiffness_test
