// Tests of the stress inside the full model: fem/solution/block_stress.hpp and
// FullBlock::strongest_stress.
#include "fem/solution/block_stress.hpp"
#include "tests/fem/bent_block.hpp"

#include <gtest/gtest.h>

namespace asperity::fem::block_stress_test {

using mechanics::ContactLaw;
using mechanics::Control;
using mechanics::FarBoundary;

// The von Mises stress is the axial stress in uniaxial tension, sqrt(3) times
// the shear stress in shear, and zero under hydrostatic pressure. Tolerance:
// roundoff of a few operations.
TEST(VonMises, IsThatOfUniaxialStressShearAndPressure) {
  StressTensor uniaxial, shear;
  uniaxial[2][2] = -3e6;
  shear[0][1] = 2e6;

  EXPECT_NEAR(von_mises(uniaxial) / 3e6, 1.0, 1e-14);
  EXPECT_NEAR(von_mises(shear) / (std::sqrt(3.0) * 2e6), 1.0, 1e-14);
  EXPECT_NEAR(von_mises(5e6 * dealii::unit_symmetric_tensor<3>()), 0.0, 1e-8);
  EXPECT_NEAR(largest_shear(uniaxial) / 1.5e6, 1.0, 1e-14);
  EXPECT_NEAR(largest_shear(shear) / 2e6, 1.0, 1e-14);
}

// Under a uniform pressure with fixed sides the von Mises stress is |sigma_zz -
// sigma_xx| = (1 - 2 nu)/(1 - nu) p, the largest in the layer with the smallest
// nu, and the maximum shear stress is half of it. Tolerance: roundoff of a
// direct solve, 1e-16 times a condition number of some 1e5. Two principal
// stresses are equal, and the closed form of the cubic determines them to the
// square root of roundoff only.
TEST(StrongestStress, IsThatOfUniaxialStrain) {
  const Grid grid{6, 4, 1e-6, 0.7e-6};
  const double p = 1e6;
  const LayeredBlock block{{elastic_layer(2e-7, soft_modulus, 0.4),
                            elastic_layer(2e-7, soft_modulus, 0.4),
                            elastic_layer(3e-7, 2.0 * soft_modulus, 0.1),
                            elastic_layer(3e-7, soft_modulus, 0.3)},
                           FarBoundary::sliding};
  for (const int degree : {1, 2}) {
    const auto full =
        make_full_block(grid, degree, block, LinearSolver::direct);
    EXPECT_EQ(full->strongest_stress().von_mises, 0.0);

    const BlockSolution found = full->solve(
        std::vector<double>(grid.size(), 0.0), {Control::nominal_pressure, p},
        {ContactLaw::penalty, 10.0 * soft_modulus / grid.spacing_x(), 1e-8,
         50});
    const StressPeak peak = full->strongest_stress();

    ASSERT_TRUE(found.converged) << found.note;
    EXPECT_NEAR(peak.von_mises / (0.8 / 0.9 * p), 1.0, 1e-11);
    EXPECT_NEAR(peak.largest_shear / peak.von_mises, 0.5, 1e-7);
    EXPECT_GT(peak.depth, 4e-7);
    EXPECT_LT(peak.depth, 7e-7);
    EXPECT_EQ(peak.depth, peak.place[2]);
  }
}

// Verifies that a stress that is linear in each material is exact at every
// vertex of every cell, on either side of the interface, with and without
// hanging nodes. Tolerance: roundoff of u times the derivative, 1e-16 times
// some 1e2.
TEST_P(BentBlock, HasALinearStressExactlyAtItsVertices) {
  const BlockSystem system(problem());
  BlockStress stress(system, displacement_of(system.space()));
  const double scale = near_.lame_modulus * strain_;
  std::size_t n_checked = 0;

  stress.at_vertices([&](const BlockStress::Cell& cell,
                         std::span<const StressTensor> at_vertex) {
    const Moduli& material = cell->center()[2] < interface_ ? near_ : far_;
    for (const unsigned int v : cell->vertex_indices()) {
      const double strain = strain_at(cell->vertex(v)[2]);
      ++n_checked;
      EXPECT_NEAR(at_vertex[v][2][2],
                  (material.lame_modulus + 2.0 * material.shear_modulus) *
                      strain,
                  1e-12 * scale);
      EXPECT_NEAR(at_vertex[v][0][0], material.lame_modulus * strain,
                  1e-12 * scale);
      EXPECT_NEAR(at_vertex[v][0][2], 0.0, 1e-12 * scale);
    }
  });

  EXPECT_GT(n_checked, 100U);
}

// The maximum of 2 mu |strain| is at the Gauss points nearest to the surface of
// the stiffer layer, and the first of these is returned. Tolerance: as above.
TEST_P(BentBlock, FindsThePeakAtTheGaussPointNextToTheSurface) {
  const BlockSystem system(problem());
  const double edge = depth_ / (GetParam().hangs ? 8.0 : 4.0);
  const double first = edge * 0.5 * (1.0 - std::sqrt(0.6));

  const StressPeak peak =
      BlockStress(system, displacement_of(system.space())).strongest();

  EXPECT_NEAR(peak.depth / first, 1.0, 1e-10);
  EXPECT_NEAR(peak.von_mises / (2.0 * near_.shear_modulus * strain_ *
                                (1.0 - 2.0 * first / depth_)),
              1.0, 1e-11);
}

INSTANTIATE_TEST_SUITE_P(Cells, BentBlock, all_bent_blocks(), name_of_bent);

// At a vertex on a kink of the strain the stress is the mean of both sides,
// weighted by the volumes of their cells, whichever rank owns these: a quarter
// of 1 and three quarters of -1/3 across z = L/4, where u_z has its ridge, and
// halves of -1 and 1 across the kinks at x = L/2 and y = L/2. Tolerance:
// roundoff of u times the derivative, 1e-16 times some 1e2.
TEST(VertexStress, IsWeighedByVolume) {
  constexpr double length = 1e-6, kink = 0.25e-6, strain = 1e-3;
  const Grid grid{8, 8, length, length};
  const Moduli material = moduli({soft_modulus, 0.3});
  const BlockProblem problem{
      .grid = grid,
      .mesh = meshes::layered_mesh(grid, {kink, length - kink}),
      .degree = 1,
      .moduli = ModuliField(material),
      .far_boundary = FarBoundary::sliding,
      .sides = mechanics::BlockSides::free,
      .linear_solver = LinearSolver::direct};
  const auto ridge = [&](double z) { return std::min(z, (length - z) / 3.0); };
  const auto along = [&](const dealii::Point<3>& place) {
    return 1.0 + std::abs(place[0] / length - 0.5) +
           std::abs(place[1] / length - 0.5);
  };
  const auto side_of = [&](double x) {
    return std::abs(x / length - 0.5) < 1e-6 ? 0.0
           : x > 0.5 * length                ? 1.0
                                             : -1.0;
  };
  const BlockSystem system(problem);
  BlockStress stress(
      system, vertical_displacement(system.space(), [&](const auto& place) {
        return strain * ridge(place[2]) * along(place);
      }));
  const double mu = material.shear_modulus;
  const double scale = (material.lame_modulus + 2.0 * mu) * strain;

  stress.at_vertices([&](const BlockStress::Cell& cell,
                         std::span<const StressTensor> at_vertex) {
    for (const unsigned int v : cell->vertex_indices()) {
      const dealii::Point<3> place = cell->vertex(v);
      const double slope = place[2] < 0.5 * kink   ? 1.0
                           : place[2] < 2.0 * kink ? 0.0
                                                   : -1.0 / 3.0;
      const double across = mu * strain * ridge(place[2]) / length;
      EXPECT_NEAR(at_vertex[v][2][2], scale * slope * along(place),
                  1e-12 * scale);
      EXPECT_NEAR(at_vertex[v][0][2], across * side_of(place[0]),
                  1e-12 * scale);
      EXPECT_NEAR(at_vertex[v][1][2], across * side_of(place[1]),
                  1e-12 * scale);
    }
  });
}

// Verifies the place of a maximum in the second body, which is softer, has the
// smaller Poisson's ratio and thus the larger shear: below the contact surface,
// with a depth above 0. Tolerance: as for uniaxial strain, with the value
// itself in front of the roundoff.
TEST(StrongestStress, IsFoundInTheSecondBody) {
  const Grid grid{4, 4, 1e-6, 1e-6};
  const double p = 1e6;
  BlockProblem problem = boxes_problem(grid, 1, {soft_modulus, 0.4}, 1e-6);
  problem.counter = mechanics::BodyModuli{soft_modulus, 0.1};
  const auto full = make_full_block(problem);

  const BlockSolution found = full->solve(
      std::vector<double>(grid.size(), 0.0), {Control::nominal_pressure, p},
      {ContactLaw::penalty, 10.0 * soft_modulus / grid.spacing_x(), 1e-8, 50});
  const StressPeak peak = full->strongest_stress();

  ASSERT_TRUE(found.converged) << found.note;
  EXPECT_NEAR(peak.von_mises / (0.8 / 0.9 * p), 1.0, 1e-10);
  EXPECT_LT(peak.place[2], 0.0);
  EXPECT_EQ(peak.depth, -peak.place[2]);
}

} // namespace asperity::fem::block_stress_test
