// Tests of fem/solution/block_section.hpp: the section of a block whose stress
// is known, at points that are not vertices, on any number of ranks.
#include "fem/solution/block_section.hpp"
#include "tests/fem/bent_block.hpp"

#include <gtest/gtest.h>

namespace asperity::fem::block_section_test {

class SectionOfBentBlock : public BentBlock {
protected:
  SectionOfBentBlock() : system_(problem()) {}

  std::vector<double> section(const SectionPlane& plane) const {
    BlockStress stress(system_, displacement_of(system_.space()));
    return von_mises_in(plane, system_.space(), stress);
  }

  /// The von Mises stress of uniaxial strain: 2 mu |strain|.
  double expected(double depth) const {
    const Moduli& material = depth <= interface_ ? near_ : far_;
    return 2.0 * material.shear_modulus * std::abs(strain_at(depth));
  }

  BlockSystem system_;
};

// Verifies that a stress that is linear in each material is reproduced inside
// cells, on their faces and edges and on the sides of the block; on the
// interface it is that of the material nearer to the contact surface.
// Tolerance: roundoff of u times the derivative, and of the position in the
// cell, 1e-16 times some 1e3.
TEST_P(SectionOfBentBlock, IsTheStressForAnyCells) {
  SectionPlane plane;
  plane.x = {0.9e-6, 0.0, 0.37e-6, 0.5e-6, depth_, 0.123e-6};
  plane.depth = {0.77e-6, 0.0, 0.11e-6, 0.25e-6, interface_, 0.51e-6, depth_};
  for (const double y : {0.0, 0.25e-6, 0.61e-6, depth_}) {
    plane.y = y;
    const std::vector<double> found = section(plane);
    ASSERT_EQ(found.size(), plane.x.size() * plane.depth.size());
    for (std::size_t row = 0; row < plane.depth.size(); ++row)
      for (std::size_t i = 0; i < plane.x.size(); ++i)
        EXPECT_NEAR(found[row * plane.x.size() + i], expected(plane.depth[row]),
                    1e-11 * expected(0.0))
            << "x " << plane.x[i] << " y " << y << " z " << plane.depth[row];
  }
}

TEST_P(SectionOfBentBlock, IsNaNOutsideOfTheMesh) {
  const std::vector<double> found =
      section({0.3e-6, false, {-0.1e-6, 0.3e-6, 1.1e-6}, {0.2e-6, 1.2e-6}});
  const std::vector<double> beside =
      section({1.3e-6, false, {0.3e-6}, {0.2e-6}});
  const std::vector<double> counter =
      section({0.3e-6, true, {0.3e-6}, {0.2e-6}});

  EXPECT_GT(found[1], 0.0);
  for (const std::size_t i : {0U, 2U, 3U, 4U, 5U})
    EXPECT_TRUE(std::isnan(found[i])) << i;
  EXPECT_TRUE(std::isnan(beside[0]));
  EXPECT_TRUE(std::isnan(counter[0]));
}

INSTANTIATE_TEST_SUITE_P(Cells, SectionOfBentBlock, all_bent_blocks(),
                         name_of_bent);

// Each body has its own section: (1 - 2 nu)/(1 - nu) p under a uniform
// pressure, including the contact surface. Tolerance: roundoff of a direct
// solve, 1e-16 times a condition number of some 1e5.
TEST(SectionOfTwoBodies, IsThatOfTheRequestedBody) {
  const Grid grid{4, 4, 1e-6, 1e-6};
  const double p = 1e6;
  BlockProblem problem = boxes_problem(grid, 1, {soft_modulus, 0.4}, 1e-6);
  problem.counter = mechanics::BodyModuli{soft_modulus, 0.1};
  problem.linear_solver = LinearSolver::direct;
  const auto full = make_full_block(problem);

  const BlockSolution found =
      full->solve(std::vector<double>(grid.size(), 0.0),
                  {mechanics::Control::nominal_pressure, p},
                  {mechanics::ContactLaw::penalty,
                   10.0 * soft_modulus / grid.spacing_x(), 1e-8, 50});

  ASSERT_TRUE(found.converged) << found.note;
  for (const double depth : {0.0, 0.3e-6, 1e-6}) {
    EXPECT_NEAR(full->section({0.4e-6, false, {0.7e-6}, {depth}})[0] / p,
                0.2 / 0.6, 1e-10);
    EXPECT_NEAR(full->section({0.4e-6, true, {0.7e-6}, {depth}})[0] / p,
                0.8 / 0.9, 1e-10);
  }
}

} // namespace asperity::fem::block_section_test
