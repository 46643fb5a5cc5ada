// Claims about the stress inside the whole block: fem/block_stress.hpp and
// FullBlock::strongest_stress.
#include "fem/block_stress.hpp"
#include "meshes/layered_mesh.hpp"

#include <gtest/gtest.h>

#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"

namespace asperity::fem {
namespace {

using cases::BlockSides;
using cases::ContactLaw;
using cases::Control;
using cases::TopFace;

// Claims of the definition: the axial stress itself, sqrt(3) times a shear,
// nothing of a pressure. Tolerance: rounding of a few operations.
TEST(VonMises, IsThatOfUniaxialStressShearAndPressure) {
  StressTensor uniaxial, shear;
  uniaxial[2][2] = -3e6;
  shear[0][1] = 2e6;

  EXPECT_NEAR(von_mises(uniaxial) / 3e6, 1.0, 1e-14);
  EXPECT_NEAR(von_mises(shear) / (std::sqrt(3.0) * 2e6), 1.0, 1e-14);
  EXPECT_NEAR(von_mises(5e6 * dealii::unit_symmetric_tensor<3>()), 0.0, 1e-8);
}

// Claim: under a uniform pressure between sides that do not move, von Mises is
// |sigma_zz - sigma_xx| = (1 - 2 nu)/(1 - nu) p, the largest in the layer of
// the smallest nu. Tolerance: rounding of a direct solve, 1e-16 times a
// condition of some 1e5.
TEST(StrongestStress, IsThatOfUniaxialStrain) {
  const Grid grid{6, 4, 1e-6, 0.7e-6};
  const double p = 1e6;
  const LayeredBlock block{{elastic_layer(2e-7, soft_modulus, 0.4),
                            elastic_layer(2e-7, soft_modulus, 0.4),
                            elastic_layer(3e-7, 2.0 * soft_modulus, 0.1),
                            elastic_layer(3e-7, soft_modulus, 0.3)},
                           TopFace::sliding};
  for (const int degree : {1, 2}) {
    const auto whole =
        make_full_block(grid, degree, block, LinearSolver::direct);
    EXPECT_EQ(whole->strongest_stress().von_mises, 0.0);

    const BlockSolution found = whole->solve(
        std::vector<double>(grid.size(), 0.0), {Control::nominal_pressure, p},
        {ContactLaw::penalty, 10.0 * soft_modulus / grid.spacing_x(), 1e-8,
         50});
    const StressPeak peak = whole->strongest_stress();

    ASSERT_TRUE(found.converged) << found.note;
    EXPECT_NEAR(peak.von_mises / (0.8 / 0.9 * p), 1.0, 1e-11);
    EXPECT_GT(peak.depth, 4e-7);
    EXPECT_LT(peak.depth, 7e-7);
    EXPECT_EQ(peak.depth, peak.place[2]);
  }
}

/// A block whose sides are free, for displacements that no load made.
struct Bent {
  const char* name;
  meshes::CellShape shape;
  bool hangs;
};

class BentBlock : public ::testing::TestWithParam<Bent> {
protected:
  static constexpr double depth_ = 1e-6;
  const Grid grid_{8, 8, depth_, depth_};
  const Moduli near_ = moduli({2.0 * soft_modulus, 0.3});
  const Moduli far_ = moduli({soft_modulus, 0.2});

  BlockProblem problem() const {
    BlockProblem problem{
        .grid = grid_,
        .mesh = meshes::layered_mesh({4, 4, depth_, depth_},
                                     std::vector<double>(4, depth_ / 4.0)),
        .degree = 2,
        .moduli = ModuliField(far_),
        .top = TopFace::sliding,
        .sides = BlockSides::free,
        .linear_solver = LinearSolver::direct};
    problem.moduli.add_layer(depth_ / 2.0, near_);
    if (GetParam().hangs)
      problem.mesh.refine_below = {depth_ / 4.0};
    if (GetParam().shape == meshes::CellShape::tetrahedron) {
      problem.contact_at = cases::ContactPoints::gauss;
      problem.mesh = tetrahedra_of(problem.mesh);
    }
    return problem;
  }

  /// u_z = strain_ z (L - z) / L, which quadratic functions hold.
  static constexpr double strain_ = 1e-3;

  static dealii::TrilinosWrappers::MPI::Vector
  displacement_of(const BlockSpace& space) {
    auto displacement = space.make_vector();
    const auto& support = space.element().get_unit_support_points();
    std::vector<dealii::types::global_dof_index> unknowns(support.size());
    for (const auto& cell : space.dof_handler().active_cell_iterators()) {
      if (!cell->is_locally_owned())
        continue;
      cell->get_dof_indices(unknowns);
      for (unsigned int i = 0; i < unknowns.size(); ++i) {
        if (space.element().system_to_component_index(i).first != 2 ||
            !space.owned().is_element(unknowns[i]))
          continue;
        const double z =
            space.mapping().transform_unit_to_real_cell(cell, support[i])[2];
        displacement(unknowns[i]) = strain_ * z * (depth_ - z) / depth_;
      }
    }
    displacement.compress(dealii::VectorOperation::insert);
    return displacement;
  }
};

// Claim: a stress that is linear in each material is that at every vertex of
// every cell, each side of the interface its own, hanging nodes or not.
// Tolerance: rounding of u times the derivative, 1e-16 times some 1e2.
TEST_P(BentBlock, HasALinearStressExactlyAtItsVertices) {
  const BlockSystem system(problem());
  BlockStress stress(system, displacement_of(system.space()));
  const double scale = near_.lame_modulus * strain_;
  std::size_t n_checked = 0;

  stress.at_vertices([&](const BlockStress::Cell& cell,
                         std::span<const StressTensor> at_vertex) {
    const Moduli& material = cell->center()[2] < depth_ / 2.0 ? near_ : far_;
    for (const unsigned int v : cell->vertex_indices()) {
      const double strain = strain_ * (1.0 - 2.0 * cell->vertex(v)[2] / depth_);
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

// Claim: the peak of 2 mu |strain| is at the Gauss points nearest to the face
// of the stiffer layer, and of these at the first. Tolerance: as above.
TEST_P(BentBlock, FindsThePeakAtTheGaussPointNextToTheFace) {
  if (GetParam().shape == meshes::CellShape::tetrahedron)
    GTEST_SKIP() << "of boxes only";
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

INSTANTIATE_TEST_SUITE_P(
    Cells, BentBlock,
    ::testing::Values(Bent{"boxes", meshes::CellShape::hexahedron, false},
                      Bent{"hanging", meshes::CellShape::hexahedron, true},
                      Bent{"tetrahedra", meshes::CellShape::tetrahedron,
                           false}),
    [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace asperity::fem
