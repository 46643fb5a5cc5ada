// Tests of fem/hexahedra/cell_tangents.hpp: the stiffness of plastic cells
// without a matrix, compared with sums over the Gauss points by deal.II, and
// its inverse by multigrid with elastic levels.
#include "fem/linear/hexahedron_block.hpp"
#include "meshes/hanging_mesh.hpp"
#include "tests/fem/block_vectors.hpp"
#include "tests/fem/blocks.hpp"
#include "tests/fem/meshes.hpp"
#include "tests/fem/tangent_stress.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_values.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace asperity::fem::cell_tangents_test {

using Tensor = dealii::SymmetricTensor<2, 3>;

constexpr double length = 1e-6; // m

/// A shaken block with hanging nodes.
BlockProblem shaken_block(int cells) {
  BlockProblem problem{
      Grid{2 * cells, 2 * cells, length, length},
      meshes::hanging_mesh({cells, cells, length, length}, length, cells / 4),
      2, ModuliField(moduli(mechanics::BodyModuli{soft_modulus, 0.3}))};
  problem.sides = mechanics::BlockSides::free;
  shake(problem.mesh, 0.4 * length / cells);
  return problem;
}

/// Tangents of radial return at cells near the contact surface: a random
/// deviatoric direction at each Gauss point.
/// @param hardening  smallest stiffness along the direction of flow, in units
///                   of the elastic one
std::vector<CellTangents> flowing_cells(const BlockSystem& system,
                                        double hardening) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<CellTangents> cells;
  std::size_t next = 0;
  for (const auto& cell :
       system.space().dof_handler().active_cell_iterators()) {
    const std::size_t own = next++;
    if (cell->center()[2] > 0.3 * length || own % 3 == 0)
      continue;
    const Moduli elastic = system.moduli_of(cell);
    CellTangents& flowing = cells.emplace_back();
    flowing.cell = own;
    for (PointTangent& point : flowing.points) {
      // theta = 0.9, so that 2 mu (theta - theta-bar) = 2 mu hardening.
      point.shear = 0.9 * elastic.shear_modulus;
      point.lame = elastic.lame_modulus + 2.0 / 3.0 * elastic.shear_modulus -
                   2.0 / 3.0 * point.shear;
      Tensor direction;
      for (unsigned int i = 0; i < 6; ++i)
        direction.access_raw_entry(i) = normal(random);
      direction = deviator(direction);
      direction *= std::sqrt(2.0 * elastic.shear_modulus * (0.9 - hardening)) /
                   direction.norm();
      point.softening = {direction[0][0], direction[1][1], direction[2][2],
                         direction[1][2], direction[2][0], direction[0][1]};
    }
  }
  return cells;
}

/// K u by a sum over the Gauss points, zero at constrained unknowns.
BlockVector stiffness_times(const BlockSystem& system,
                            const std::vector<CellTangents>& tangents,
                            BlockVector displacement) {
  const BlockSpace& space = system.space();
  space.constraints().distribute(displacement);
  dealii::FEValues<3> values(
      space.mapping(), space.element(), dealii::QGauss<3>(3),
      dealii::update_gradients | dealii::update_JxW_values);
  const dealii::FEValuesExtractors::Vector field(0);
  const unsigned int n = space.element().n_dofs_per_cell();
  std::vector<dealii::types::global_dof_index> unknowns(n);
  std::vector<Tensor> strains(points_in_hexahedron);
  dealii::Vector<double> own_forces(n);
  BlockVector forces = space.make_vector();
  std::size_t number = 0;
  auto next = tangents.begin();
  for (const auto& cell : space.dof_handler().active_cell_iterators()) {
    values.reinit(cell);
    values[field].get_function_symmetric_gradients(displacement, strains);
    cell->get_dof_indices(unknowns);
    const Moduli moduli = system.moduli_of(cell);
    const bool flows = next != tangents.end() && next->cell == number;
    ++number;
    own_forces = 0.0;
    for (unsigned int q = 0; q < points_in_hexahedron; ++q) {
      const Tensor stress = stress_of(
          flows ? next->points.at(q)
                : PointTangent{moduli.lame_modulus, moduli.shear_modulus, {}},
          strains[q]);
      for (unsigned int i = 0; i < n; ++i)
        own_forces(i) +=
            stress * values[field].symmetric_gradient(i, q) * values.JxW(q);
    }
    if (flows)
      ++next;
    space.constraints().distribute_local_to_global(own_forces, unknowns,
                                                   forces);
  }
  forces.compress(dealii::VectorOperation::add);
  return forces;
}

// Verifies K u of a block with flowing cells, and that the cells are elastic
// again afterwards. Tolerance: roundoff of a sum over the unknowns of a cell.
TEST(CellTangents, ReplaceTheModuliOfTheirCells) {
  const BlockProblem problem = shaken_block(8);
  const BlockSystem system(problem);
  ASSERT_TRUE(is_hexahedron_block(system));
  const std::vector<CellTangents> tangents = flowing_cells(system, 0.01);
  ASSERT_GT(tangents.size(), 20U);
  HexahedronBlock block(problem, system);
  const BlockVector displacement = random_vector(system, 1);
  BlockVector found(displacement), again(displacement);

  block.set_tangents(tangents);
  block.vmult(found, displacement);
  block.set_tangents({});
  block.vmult(again, displacement);

  const BlockVector elastic = stiffness_times(system, {}, displacement);
  const BlockVector flowing = stiffness_times(system, tangents, displacement);
  EXPECT_GT(relative_difference(elastic, flowing), 0.05);
  EXPECT_LT(relative_difference(found, flowing), 1e-13);
  EXPECT_LT(relative_difference(again, elastic), 1e-13);
}

// Verifies that conjugate gradients with the elastic cycle solve for the
// displacement of flowing cells; with a hundredth of the elastic stiffness
// along the flow, they take at most four times the iterations.
TEST(CellTangents, AreSolvedWithElasticLevels) {
  const BlockProblem problem = shaken_block(8);
  const BlockSystem system(problem);
  const std::vector<CellTangents> tangents = flowing_cells(system, 0.01);
  HexahedronBlock block(problem, system);
  const BlockVector forces = random_vector(system, 2);
  const double tolerance = 1e-10 * forces.l2_norm();
  block.prepare(std::vector<double>(system.contact().size(), 0.0),
                std::vector<bool>(system.contact().size(), false), false);
  BlockVector displacement(forces);
  displacement = 0.0;
  const LinearSolution elastic =
      block.solve(displacement, forces, tolerance, 200);
  ASSERT_TRUE(elastic.has_converged);

  block.set_tangents(tangents);
  displacement = 0.0;
  const LinearSolution flowing =
      block.solve(displacement, forces, tolerance, 200);

  EXPECT_TRUE(flowing.has_converged);
  EXPECT_LE(flowing.iterations, 4 * elastic.iterations);
  EXPECT_LT(relative_difference(stiffness_times(system, tangents, displacement),
                                forces),
            1e-9);
  RecordProperty("elastic", elastic.iterations);
  RecordProperty("flowing", flowing.iterations);
}

} // namespace asperity::fem::cell_tangents_test
